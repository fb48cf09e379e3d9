using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The curves of a run, kept for the picture of its case: curves/CASE.METHOD.csv.</summary>
    public static class CurveFile
    {
        internal static readonly string[] Columns = { "run", "series", "reference", "x", "y" };

        /// <summary>Name of a file below the chart's folder.</summary>
        public static string PathOf(string folder, string caseName, string method) => Path.Combine(folder, NameOf(caseName, method));

        internal static string NameOf(string caseName, string method) => "curves/" + caseName + "." + method + ".csv";

        /// <summary>Writes the curves of a run.</summary>
        /// <param name="file">The file.</param>
        /// <param name="run">What the run is called in the picture.</param>
        /// <param name="curves">Its curves.</param>
        public static void Write(string file, string run, IEnumerable<CaseSeries> curves)
        {
            IEnumerable<string> lines = from curve in curves
                                        from i in Enumerable.Range(0, curve.X.Count)
                                        select CsvText.Join(new[] { run, curve.Name, curve.IsReference ? "1" : "0", CsvText.Text(curve.X[i]), CsvText.Text(curve.Y[i]) });
            CsvText.WriteWhole(file, new[] { CsvText.Join(Columns) }.Concat(lines));
        }

        /// <summary>Reads curves back; none where there is no file.</summary>
        /// <param name="file">The file.</param>
        /// <param name="run">What the run is called.</param>
        public static IReadOnlyList<CaseSeries> Read(string file, out string run)
        {
            var curves = new List<CaseSeries>();
            run = "";
            if (!File.Exists(file))
                return curves;
            foreach (string line in File.ReadLines(file).Skip(1))
            {
                string[] cells = CsvText.Split(line);
                run = cells[0];
                CaseSeries curve = curves.Find(c => c.Name == cells[1] && c.IsReference == (cells[2] == "1"));
                if (curve == null)
                    curves.Add(curve = new CaseSeries(cells[1], cells[2] == "1"));
                curve.Add(Number(cells[3]), Number(cells[4]));
            }
            return curves;
        }

        static double Number(string cell) => cell.Length == 0 ? double.NaN : double.Parse(cell, NumberStyles.Float, CultureInfo.InvariantCulture);
    }
}
