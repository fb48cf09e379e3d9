using System;
using System.Collections.Generic;
using System.IO;

namespace SphFluid.Validation
{
    /// <summary>Files of finished runs that a later session of the same device goes on with.</summary>
    static class ResumedTable
    {
        const string Cure = "Choose another folder with --out, or move the file away.";

        /// <summary>The rows of a file; none where there is no file.</summary>
        /// <param name="file">The file.</param>
        /// <param name="columns">The columns that it must have.</param>
        /// <param name="read">A row of a line; FormatException or OverflowException for a broken one.</param>
        /// <param name="deviceOf">The device of a row.</param>
        /// <param name="device">The device that goes on.</param>
        /// <exception cref="CommandLineException">Other columns, a broken line, or another device's runs.</exception>
        public static List<T> Load<T>(string file, IReadOnlyList<string> columns, Func<string, T> read, Func<T, string> deviceOf, string device)
        {
            var rows = new List<T>();
            if (!File.Exists(file))
                return rows;
            string[] lines = File.ReadAllLines(file);
            if (lines.Length == 0 || lines[0] != CsvText.Join(columns))
                throw new CommandLineException($"'{file}' does not have the columns of this version. {Cure}");
            for (int i = 1; i < lines.Length; i++)
            {
                try
                {
                    rows.Add(read(lines[i]));
                }
                catch (Exception exception) when (exception is FormatException || exception is OverflowException)
                {
                    throw new CommandLineException($"'{file}' has a broken line {i + 1}: {exception.Message}. Remove the line, and its run is done again.");
                }
            }
            T other = rows.Find(r => deviceOf(r) != device);
            if (rows.Exists(r => deviceOf(r) != device))
                throw new CommandLineException($"'{file}' has runs of '{deviceOf(other)}', and this is '{device}'. {Cure}");
            return rows;
        }

        /// <summary>The cells of a line.</summary>
        /// <exception cref="FormatException">Their number is another.</exception>
        public static string[] Cells(string line, int count)
        {
            string[] cells = CsvText.Split(line);
            return cells.Length == count ? cells : throw new FormatException($"{cells.Length} cells instead of {count}");
        }

        /// <summary>A number of a cell; not a number for an empty one.</summary>
        public static double Number(string cell) => cell.Length == 0 ? double.NaN
            : double.Parse(cell, System.Globalization.NumberStyles.Float, System.Globalization.CultureInfo.InvariantCulture);
    }
}
