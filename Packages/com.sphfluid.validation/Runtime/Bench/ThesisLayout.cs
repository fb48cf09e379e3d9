using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Tables 3 and 4 of the thesis: a block of chapter 6 a column, and the published figures.</summary>
    public sealed class ThesisLayout : BenchLayout
    {
        /// <summary>The form for some blocks.</summary>
        /// <param name="table">Name of the table: thesis or sweep.</param>
        /// <param name="blocks">Names of the blocks, a column each.</param>
        public ThesisLayout(string table, IEnumerable<string> blocks) : base(table)
        {
            Format
                .Text("surface", row => row.Config.Surface)
                .Count("particles", row => row.Particles)
                .Count("grid", row => row.Config.Grid)
                .Number("spacing", row => row.Spacing)
                .Number("support", row => row.Support)
                .Number("neighbours_mean", row => row.NeighboursMean);
            AddTimes()
                .Number("steps_per_s", row => row.FramesPerSecond)
                .Number("mpsteps_per_s", row => row.MillionParticleSteps);
            AddParts("gpu_ms.", blocks, (row, i) => row.Block(i));
            Format.Number("blocks_over_step", row => row.BlocksOverStep);
            AddSamples()
                .Text("published_fps_gtx_580",
                    row => PublishedTables.System1(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? "")
                .Text("published_fps_gtx_430",
                    row => PublishedTables.System2(row.Config, row.Particles)?.ToString(CultureInfo.InvariantCulture) ?? "")
                .Text("note", row => row.Note);
        }

        /// <inheritdoc/>
        public override string Head =>
            $"{"",-16}{"particles",10}{"k",7}{"dispatches",12}{"GPU ms",10}{"1/s",10}{"GTX 580",10}{"GTX 430",10}{"blocks",8}";

        /// <inheritdoc/>
        public override string Line(BenchRow row) =>
            string.Format(CultureInfo.InvariantCulture, "{0,-16}{1,10}{2,7:F1}{3,12}{4,10:F3}{5,10:F1}{6,10}{7,10}{8,8:P0}  {9}",
                row.Config.Title, row.Particles, row.NeighboursMean, row.Dispatches, row.Frame.Median, row.FramesPerSecond,
                PublishedTables.System1(row.Config, row.Particles), PublishedTables.System2(row.Config, row.Particles),
                row.BlocksOverStep, row.Note);
    }
}
