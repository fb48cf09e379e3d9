using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>Lines of comma-separated files (RFC 4180, no line breaks in cells).</summary>
    public static class CsvText
    {
        /// <summary>A line of these cells; those with commas or quotes are quoted.</summary>
        public static string Join(IEnumerable<string> cells) => string.Join(",", cells.Select(Quoted));

        /// <summary>The cells of a line: <c>a,"b, ""c""",</c> has the three cells a, b, "c" and nothing.</summary>
        public static string[] Split(string line)
        {
            var cells = new List<string>();
            var cell = new StringBuilder();
            bool quoted = false;
            for (int i = 0; i < line.Length; i++)
            {
                char c = line[i];
                if (c == '"' && quoted && i + 1 < line.Length && line[i + 1] == '"')
                {
                    cell.Append('"');
                    i++;
                }
                else if (c == '"')
                {
                    quoted = !quoted;
                }
                else if (c == ',' && !quoted)
                {
                    cells.Add(cell.ToString());
                    cell.Clear();
                }
                else
                {
                    cell.Append(c);
                }
            }
            cells.Add(cell.ToString());
            return cells.ToArray();
        }

        /// <summary>A whole number.</summary>
        public static string Text(long value) => value.ToString(CultureInfo.InvariantCulture);

        /// <summary>Six digits, more than a measurement has; nothing for what is not a finite number.</summary>
        public static string Text(double value) =>
            double.IsNaN(value) || double.IsInfinity(value) ? "" : value.ToString("G6", CultureInfo.InvariantCulture);

        /// <summary>A number of a cell; not a number for an empty one.</summary>
        /// <exception cref="FormatException">The cell holds none.</exception>
        public static double Number(string cell) =>
            cell.Length == 0 ? double.NaN : double.Parse(cell, NumberStyles.Float, CultureInfo.InvariantCulture);

        /// <summary>Writes a file whole: whoever stops the program finds the last whole one.</summary>
        /// <param name="file">The file; its folder is made if there is none.</param>
        /// <param name="lines">Its lines.</param>
        /// <exception cref="IOException">It cannot be written.</exception>
        public static void WriteWhole(string file, IEnumerable<string> lines)
        {
            WholeFile.Write(file, stream =>
            {
                using (var writer = new StreamWriter(stream, new UTF8Encoding(false), 1 << 16))
                {
                    foreach (string line in lines) writer.WriteLine(line);
                }
            });
        }

        private static string Quoted(string cell)
        {
            string line = cell.Replace("\r", "").Replace('\n', ' ');
            return line.IndexOfAny(new[] { ',', '"' }) < 0 ? line : "\"" + line.Replace("\"", "\"\"") + "\"";
        }
    }
}
