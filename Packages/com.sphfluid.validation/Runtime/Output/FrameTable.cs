using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A table with a row a frame. Its first column is the frame's number.</summary>
    public sealed class FrameTable
    {
        private readonly string[] columns;
        private readonly List<string[]> rows = new List<string[]>();

        /// <summary>Makes an empty table; the column "frame" comes first by itself.</summary>
        public FrameTable(params string[] columns)
        {
            this.columns = columns;
        }

        /// <summary>Adds the row of a frame; numbers are written with all their digits.</summary>
        public void Add(params double[] values)
        {
            if (values.Length != columns.Length)
            {
                throw new ArgumentException($"The table has {columns.Length} columns beside the frame, found {values.Length} values.",
                    nameof(values));
            }
            rows.Add(values.Select(v => v.ToString("R", CultureInfo.InvariantCulture)).ToArray());
        }

        /// <summary>Writes the table with the frame's number first.</summary>
        public void Write(string file)
        {
            var lines = new List<string> { "frame," + string.Join(",", columns) };
            for (int i = 0; i < rows.Count; i++) lines.Add(i.ToString(CultureInfo.InvariantCulture) + "," + string.Join(",", rows[i]));
            CsvText.WriteWhole(file, lines);
        }

        /// <summary>
        /// Puts the columns into a CSV file with a row a frame, behind its column <paramref name="after"/>. Frames without
        /// a row here get empty cells. Example: frame,time_s,cpu_ms becomes frame,time_s,steps,particles,cpu_ms.
        /// </summary>
        /// <exception cref="InvalidDataException">The file has no such column.</exception>
        public void InsertInto(string file, string after)
        {
            string[] lines = File.ReadAllLines(file);
            int place = lines.Length == 0 ? -1 : Array.IndexOf(lines[0].Split(','), after);
            if (place < 0) throw new InvalidDataException($"'{file}' has no column '{after}'.");
            lines[0] = Insert(lines[0], place + 1, columns);
            for (int i = 1; i < lines.Length; i++)
            {
                lines[i] = Insert(lines[i], place + 1, i <= rows.Count ? rows[i - 1] : new string[columns.Length]);
            }
            CsvText.WriteWhole(file, lines);
        }

        private static string Insert(string line, int place, IEnumerable<string> values)
        {
            var cells = new List<string>(line.Split(','));
            cells.InsertRange(place, values);
            return string.Join(",", cells);
        }
    }
}
