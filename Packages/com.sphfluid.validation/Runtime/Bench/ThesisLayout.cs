using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Tables 3 and 4 of the thesis: a block of chapter 6 a column, and the published figures.</summary>
    public sealed class ThesisLayout : IBenchLayout
    {
        /// <summary>The form for some blocks.</summary>
        /// <param name="blocks">Names of the blocks, a column each.</param>
        public ThesisLayout(IEnumerable<string> blocks)
        {
            var columns = new List<BenchColumn>
            {
                new BenchColumn("table", (table, row) => table.Name),
                new BenchColumn("device", (table, row) => table.Device),
                new BenchColumn("config", row => row.Config.Name),
                new BenchColumn("method", row => row.Config.Solver.MethodName),
                new BenchColumn("surface", row => row.Config.Surface),
                new BenchColumn("particles", row => CsvText.Text(row.Particles)),
                new BenchColumn("grid", row => CsvText.Text(row.Config.Grid)),
                new BenchColumn("spacing", row => CsvText.Text(row.Spacing)),
                new BenchColumn("support", row => CsvText.Text(row.Support)),
                new BenchColumn("neighbours_mean", row => CsvText.Text(row.NeighboursMean)),
                new BenchColumn("dispatches", row => CsvText.Text(row.Dispatches)),
                new BenchColumn("gpu_ms_median", row => CsvText.Text(row.Frame.Median)),
                new BenchColumn("gpu_ms_min", row => CsvText.Text(row.Frame.Minimum)),
                new BenchColumn("gpu_ms_max", row => CsvText.Text(row.Frame.Maximum)),
                new BenchColumn("steps_per_s", row => CsvText.Text(row.FramesPerSecond)),
                new BenchColumn("mpsteps_per_s", row => CsvText.Text(row.MillionParticleSteps)),
            };
            columns.AddRange(blocks.Select((name, i) => new BenchColumn("gpu_ms." + name, row => CsvText.Text(row.Block(i)))));
            columns.AddRange(new[]
            {
                new BenchColumn("blocks_over_step", row => CsvText.Text(row.BlocksOverStep)),
                new BenchColumn("samples", row => CsvText.Text(row.SampleCount)),
                new BenchColumn("frames", row => CsvText.Text(row.FrameCount)),
                new BenchColumn("date", (table, row) => table.Date),
                new BenchColumn("published_fps_gtx_580", row => PublishedTables.System1(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? ""),
                new BenchColumn("published_fps_gtx_430", row => PublishedTables.System2(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? ""),
                new BenchColumn("note", row => row.Note),
            });
            Columns = columns;
        }

        /// <inheritdoc/>
        public IReadOnlyList<BenchColumn> Columns { get; }

        /// <inheritdoc/>
        public string Head => $"{"",-16}{"particles",10}{"k",7}{"dispatches",12}{"GPU ms",10}{"1/s",10}{"GTX 580",10}{"GTX 430",10}{"blocks",8}";

        /// <inheritdoc/>
        public string Line(BenchTable table, BenchRow row) =>
            string.Format(CultureInfo.InvariantCulture, "{0,-16}{1,10}{2,7:F1}{3,12}{4,10:F3}{5,10:F1}{6,10}{7,10}{8,8:P0}  {9}",
                row.Config.Title, row.Particles, row.NeighboursMean, row.Dispatches, row.Frame.Median, row.FramesPerSecond,
                PublishedTables.System1(row.Config, row.Particles), PublishedTables.System2(row.Config, row.Particles), row.BlocksOverStep, row.Note);
    }
}
