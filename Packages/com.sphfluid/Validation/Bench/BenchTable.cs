using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A table of the benchmark and its CSV file.</summary>
    public sealed class BenchTable
    {
        readonly IReadOnlyList<string> blocks;

        /// <summary>An empty table.</summary>
        /// <param name="name">Its name, also the file's.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="date">Day of the run, e.g. 2026-11-21.</param>
        /// <param name="blocks">Names of the blocks, a column each.</param>
        public BenchTable(string name, string device, string date, IReadOnlyList<string> blocks)
        {
            Name = name;
            Device = device;
            Date = date;
            this.blocks = blocks;
        }

        /// <summary>Its name.</summary>
        public string Name { get; }

        /// <summary>The graphics device.</summary>
        public string Device { get; }

        /// <summary>Day of the run.</summary>
        public string Date { get; }

        /// <summary>The rows.</summary>
        public List<BenchRow> Rows { get; } = new List<BenchRow>();

        /// <summary>The file's lines: the head, then the rows that have a sample.</summary>
        public IEnumerable<string> Lines()
        {
            var head = new List<string>
            {
                "table", "device", "config", "method", "surface", "particles", "grid", "spacing", "support", "neighbours_mean", "dispatches",
                "gpu_ms_median", "gpu_ms_min", "gpu_ms_max", "steps_per_s", "mpsteps_per_s",
            };
            head.AddRange(blocks.Select(b => "gpu_ms." + b));
            head.AddRange(new[] { "blocks_over_step", "samples", "frames", "date", "published_fps_gtx_580", "published_fps_gtx_430", "note" });
            yield return string.Join(",", head);
            foreach (BenchRow row in Rows.Where(r => r.SampleCount > 0))
                yield return CsvText.Join(Cells(row));
        }

        /// <summary>Writes the file whole: whoever stops the program finds the last whole one.</summary>
        /// <param name="folder">Its folder, made if there is none.</param>
        /// <returns>The file.</returns>
        public string Write(string folder)
        {
            string file = Path.Combine(folder, Name + ".csv");
            CsvText.WriteWhole(file, Lines());
            return file;
        }

        IEnumerable<string> Cells(BenchRow row)
        {
            SampleStatistics frame = row.Frame;
            var cells = new List<string>
            {
                Name, Device, row.Config.Name, "thesis", row.Config.Surface, CsvText.Text(row.Particles), CsvText.Text(row.Config.Grid),
                CsvText.Text(row.Spacing), CsvText.Text(row.Support),
                CsvText.Text(row.NeighboursMean), CsvText.Text(row.Dispatches), CsvText.Text(frame.Median), CsvText.Text(frame.Minimum), CsvText.Text(frame.Maximum),
                CsvText.Text(row.FramesPerSecond), CsvText.Text(row.MillionParticleSteps),
            };
            for (int i = 0; i < blocks.Count; i++)
                cells.Add(CsvText.Text(row.Block(i)));
            cells.Add(CsvText.Text(row.BlocksOverStep));
            cells.Add(CsvText.Text(row.SampleCount));
            cells.Add(CsvText.Text(row.FrameCount));
            cells.Add(Date);
            cells.Add(PublishedTables.System1(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? "");
            cells.Add(PublishedTables.System2(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? "");
            cells.Add(row.Note);
            return cells;
        }
    }
}
