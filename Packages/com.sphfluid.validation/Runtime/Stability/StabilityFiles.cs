using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>stability.csv and limits.csv of a folder: what was measured so far, on one device.</summary>
    public sealed class StabilityFiles
    {
        readonly string folder;
        readonly List<StabilityRow> rows;
        readonly List<LimitRow> limits;

        /// <summary>What a folder has.</summary>
        /// <param name="folder">The folder.</param>
        /// <param name="device">The graphics device that goes on with it.</param>
        /// <exception cref="CommandLineException">The files cannot be gone on with.</exception>
        public StabilityFiles(string folder, string device)
        {
            this.folder = folder;
            Device = device;
            rows = ResumedTable.Load(Path.Combine(folder, StabilityRow.FileName), StabilityRow.Columns, StabilityRow.FromLine, r => r.Device, device);
            limits = ResumedTable.Load(Path.Combine(folder, LimitRow.FileName), LimitRow.Columns, LimitRow.FromLine, r => r.Device, device);
        }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>Finished runs.</summary>
        public IReadOnlyList<StabilityRow> Rows => rows;

        /// <summary>Measured borders.</summary>
        public IReadOnlyList<LimitRow> Limits => limits;

        /// <summary>Whether a run is there.</summary>
        public bool Contains(StabilityRun run) => rows.Any(r => r.Key == run.Key);

        /// <summary>Whether a border is there.</summary>
        public bool Contains(StabilityLimit limit, CaseMethod method) => limits.Any(r => r.Key == LimitRow.KeyOf(limit.Name, method.Name, limit.SupportRatio));

        /// <summary>Adds a run and writes the file whole.</summary>
        public void Add(StabilityRow row)
        {
            rows.RemoveAll(r => r.Key == row.Key);
            rows.Add(row);
            CsvText.WriteWhole(Path.Combine(folder, StabilityRow.FileName), new[] { CsvText.Join(StabilityRow.Columns) }.Concat(rows.Select(r => r.ToLine())));
        }

        /// <summary>Adds a border and writes the file whole.</summary>
        public void Add(LimitRow row)
        {
            limits.RemoveAll(r => r.Key == row.Key);
            limits.Add(row);
            CsvText.WriteWhole(Path.Combine(folder, LimitRow.FileName), new[] { CsvText.Join(LimitRow.Columns) }.Concat(limits.Select(r => r.ToLine())));
        }
    }
}
