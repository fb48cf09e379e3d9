using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A table of the benchmark and its CSV file.</summary>
    public sealed class BenchTable
    {
        /// <summary>An empty table.</summary>
        /// <param name="name">Its name, also the file's.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="date">Day of the run, e.g. 2026-11-21.</param>
        /// <param name="layout">Its form.</param>
        public BenchTable(string name, string device, string date, IBenchLayout layout)
        {
            Name = name;
            Device = device;
            Date = date;
            Layout = layout;
        }

        /// <summary>Its name.</summary>
        public string Name { get; }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>Day of the run.</summary>
        public string Date { get; }

        /// <summary>Its form.</summary>
        public IBenchLayout Layout { get; }

        /// <summary>The rows.</summary>
        public List<BenchRow> Rows { get; } = new List<BenchRow>();

        /// <summary>The file's lines: the head, then the rows that have a sample.</summary>
        public IEnumerable<string> Lines()
        {
            yield return FirstLineOf(Layout);
            foreach (BenchRow row in Rows.Where(r => r.SampleCount > 0))
                yield return CsvText.Join(Layout.Columns.Select(c => c.Cell(this, row)));
        }

        internal static string FirstLineOf(IBenchLayout layout) => string.Join(",", layout.Columns.Select(c => c.Head));

        internal static string FileOf(string table) => table + ".csv";

        /// <summary>Writes the file whole: whoever stops the program finds the last whole one.</summary>
        /// <param name="folder">Its folder, made if there is none.</param>
        /// <returns>The file.</returns>
        public string Write(string folder)
        {
            string file = Path.Combine(folder, FileOf(Name));
            CsvText.WriteWhole(file, Lines());
            return file;
        }
    }
}
