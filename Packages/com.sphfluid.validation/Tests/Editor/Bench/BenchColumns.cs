using System;
using System.Collections.Generic;
using System.Linq;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>A table of the benchmark with made-up rows, read as its file has them.</summary>
    internal sealed class BenchColumns
    {
        private readonly List<BenchRow> rows = new List<BenchRow>();
        private readonly string device, date;

        public BenchColumns(BenchLayout layout, string device, string date)
        {
            Format = layout.Format;
            this.device = device;
            this.date = date;
        }

        public TableFormat<BenchRow> Format { get; }

        public IReadOnlyList<BenchRow> Rows => rows;

        public void Add(BenchRow row)
        {
            row.Peers = rows;
            (row.Device, row.Date) = (device, date);
            rows.Add(row);
        }

        public IEnumerable<string> Lines() => Format.Lines(rows.Where(r => r.IsMeasured));

        /// <summary>A column's cells without its head.</summary>
        public string[] Column(string head)
        {
            string[][] lines = Lines().Select(CsvText.Split).ToArray();
            int column = Array.IndexOf(lines[0], head);
            return lines.Skip(1).Select(cells => cells[column]).ToArray();
        }
    }
}
