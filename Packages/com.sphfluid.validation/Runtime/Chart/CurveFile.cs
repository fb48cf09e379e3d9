using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The curves of a run, kept for the picture of its case: curves/CASE.METHOD.csv.</summary>
    public static class CurveFile
    {
        /// <summary>The first line of each file.</summary>
        internal static string FirstLine => FormatOf("", "").FirstLine;

        /// <summary>The file of a case and a method.</summary>
        internal static ResultFile Of(string caseName, string method) => FormatOf(caseName, method).File;

        /// <summary>Path of a file below the chart's folder.</summary>
        public static string PathOf(string folder, string caseName, string method) =>
            Path.Combine(folder, FormatOf(caseName, method).FileName);

        /// <summary>Writes the curves of a run.</summary>
        /// <param name="folder">The chart's folder.</param>
        /// <param name="caseName">Name of the case.</param>
        /// <param name="method">Name of the method.</param>
        /// <param name="run">What the run is called in the picture.</param>
        /// <param name="curves">Its curves.</param>
        public static void Write(string folder, string caseName, string method, string run, IEnumerable<CaseSeries> curves) =>
            FormatOf(caseName, method).Write(folder, from curve in curves
                                                     from i in Enumerable.Range(0, curve.X.Count)
                                                     select new Point
                                                     {
                                                         Run = run, Series = curve.Name, IsReference = curve.IsReference,
                                                         X = curve.X[i], Y = curve.Y[i],
                                                         Upper = curve.IsBand ? curve.Upper[i] : double.NaN
                                                     });

        /// <summary>Reads curves back; none where there is no file.</summary>
        /// <param name="folder">The chart's folder.</param>
        /// <param name="caseName">Name of the case.</param>
        /// <param name="method">Name of the method.</param>
        /// <param name="run">What the run is called.</param>
        public static IReadOnlyList<CaseSeries> Read(string folder, string caseName, string method, out string run)
        {
            TableFormat<Point> format = FormatOf(caseName, method);
            string file = Path.Combine(folder, format.FileName);
            var curves = new List<CaseSeries>();
            var point = new Point();
            foreach (string line in File.Exists(file) ? File.ReadLines(file).Skip(1) : Enumerable.Empty<string>())
            {
                format.Read(line, point);
                bool band = !double.IsNaN(point.Upper);
                CaseSeries curve = curves.Find(c => c.Name == point.Series && c.IsReference == point.IsReference && c.IsBand == band);
                if (curve == null) curves.Add(curve = new CaseSeries(point.Series, point.IsReference));
                if (band)
                    curve.AddBand(point.X, point.Y, point.Upper);
                else
                    curve.Add(point.X, point.Y);
            }
            run = point.Run;
            return curves;
        }

        private static TableFormat<Point> FormatOf(string caseName, string method) =>
            new TableFormat<Point>($"curves/{caseName}.{method}.csv")
            .Text("run", p => p.Run, (p, v) => p.Run = v)
            .Text("series", p => p.Series, (p, v) => p.Series = v)
            .Flag("reference", p => p.IsReference, (p, v) => p.IsReference = v)
            .Number("x", p => p.X, (p, v) => p.X = v)
            .Number("y", p => p.Y, (p, v) => p.Y = v)
            .Later()
            .Number("upper", p => p.Upper, (p, v) => p.Upper = v);

        private sealed class Point
        {
            public string Run = "", Series;
            public bool IsReference;
            public double X, Y, Upper = double.NaN;
        }
    }
}
