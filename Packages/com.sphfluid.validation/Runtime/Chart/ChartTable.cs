using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>accuracy.csv: what was measured so far, on one device.</summary>
    public sealed class ChartTable
    {
        /// <summary>Name of the file.</summary>
        public const string FileName = "accuracy.csv";

        readonly List<ChartRow> rows = new List<ChartRow>();

        /// <summary>An empty table.</summary>
        /// <param name="device">The graphics device.</param>
        public ChartTable(string device)
        {
            Device = device;
        }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>The lines in the order of their runs.</summary>
        public IReadOnlyList<ChartRow> Rows => rows;

        /// <summary>The table of a folder; an empty one where there is none.</summary>
        /// <param name="folder">The folder.</param>
        /// <param name="device">The graphics device that goes on with it.</param>
        /// <exception cref="CommandLineException">The file has other columns, a broken line, or another device's runs.</exception>
        public static ChartTable Load(string folder, string device)
        {
            var table = new ChartTable(device);
            table.rows.AddRange(ResumedTable.Load(Path.Combine(folder, FileName), ChartRow.Columns, ChartRow.FromLine, r => r.Device, device));
            return table;
        }

        /// <summary>Whether a run is there, with as many particles as it would have now.</summary>
        public bool Contains(ChartRun run) =>
            rows.Any(r => r.Seed == run.Seed && r.Particles == run.Config.Particles && r.Case == run.Config.Case.Name && r.Key == run.Config.Key);

        /// <summary>Adds a run; an older one of the same point and seed goes.</summary>
        /// <param name="run">The run.</param>
        /// <param name="result">What came out.</param>
        /// <param name="date">Day of the run.</param>
        public void Add(ChartRun run, CaseResult result, string date)
        {
            rows.RemoveAll(r => r.Seed == run.Seed && r.Key == run.Config.Key);
            rows.AddRange(ChartRow.Of(run, result, Device, date));
        }

        /// <summary>Writes the file whole.</summary>
        /// <param name="folder">Its folder.</param>
        public void Write(string folder) =>
            CsvText.WriteWhole(Path.Combine(folder, FileName), new[] { CsvText.Join(ChartRow.Columns) }.Concat(rows.Select(r => r.ToLine())));
    }
}
