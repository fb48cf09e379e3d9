using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Steps alone of several methods: what they cost, against each other and against the memory's speed.</summary>
    public sealed class SolverLayout : IBenchLayout
    {
        // Sizes of a growth exponent: the row's own and those down to a sixteenth of it.
        const int GrowthSpan = 16;

        /// <summary>The form for some parts of a step.</summary>
        /// <param name="parts">Names of the parts, a column each.</param>
        public SolverLayout(IEnumerable<string> parts)
        {
            var columns = new List<BenchColumn>
            {
                new BenchColumn("table", (table, row) => table.Name),
                new BenchColumn("device", (table, row) => table.Device),
                new BenchColumn("config", row => row.Config.Name),
                new BenchColumn("method", row => row.Config.Solver.MethodName),
                new BenchColumn("search", row => row.Config.Solver.Search),
                new BenchColumn("neighbour_list", row => row.IsListed ? "1" : "0"),
                new BenchColumn("triangles", row => CsvText.Text(row.Triangles)),
                new BenchColumn("particles", row => CsvText.Text(row.Particles)),
                new BenchColumn("spacing", row => CsvText.Text(row.Spacing)),
                new BenchColumn("kappa", row => CsvText.Text(row.Config.Solver.SupportRatio)),
                new BenchColumn("neighbours_mean", row => CsvText.Text(row.NeighboursMean)),
                new BenchColumn("candidates_per_neighbour", row => CsvText.Text(row.CandidatesMean / row.NeighboursMean)),
                new BenchColumn("dispatches", row => CsvText.Text(row.Dispatches)),
                new BenchColumn("gpu_ms_median", row => CsvText.Text(row.Frame.Median)),
                new BenchColumn("gpu_ms_min", row => CsvText.Text(row.Frame.Minimum)),
                new BenchColumn("gpu_ms_max", row => CsvText.Text(row.Frame.Maximum)),
                new BenchColumn("mpsteps_per_s", row => CsvText.Text(row.MillionParticleSteps)),
                new BenchColumn("mpairs_per_s", row => CsvText.Text(row.MillionParticleSteps * row.NeighboursMean)),
                new BenchColumn("speedup_thesis_27", (table, row) => CsvText.Text(SpeedUp(table, row, BenchSolver.ThesisCells))),
                new BenchColumn("speedup_thesis_8", (table, row) => CsvText.Text(SpeedUp(table, row, BenchSolver.ThesisOctant))),
            };
            columns.AddRange(parts.Select((name, i) => new BenchColumn("share." + name, row => CsvText.Text(row.Share(i)))));
            columns.AddRange(new[]
            {
                new BenchColumn("blocks_over_step", row => CsvText.Text(row.BlocksOverStep)),
                new BenchColumn("bytes_per_particle", row => CsvText.Text((double)StepBytes.Of(row) / row.Particles)),
                new BenchColumn("copy_gb_per_s", row => CsvText.Text(1e-9 * row.CopySpeed)),
                new BenchColumn("roofline_ms", row => CsvText.Text(Roofline(row))),
                new BenchColumn("roofline_fraction", row => CsvText.Text(Roofline(row) / row.Frame.Median)),
                new BenchColumn("growth_exponent", (table, row) => CsvText.Text(Growth(table, row))),
                new BenchColumn("samples", row => CsvText.Text(row.SampleCount)),
                new BenchColumn("frames", row => CsvText.Text(row.FrameCount)),
                new BenchColumn("date", (table, row) => table.Date),
            });
            Columns = columns;
        }

        /// <inheritdoc/>
        public IReadOnlyList<BenchColumn> Columns { get; }

        /// <inheritdoc/>
        public string Head =>
            $"{"",-20}{"particles",10}{"k",7}{"tests/k",9}{"dispatches",12}{"GPU ms",10}{"over 27",9}{"over 8",8}{"sort",6}{"roofline",10}{"growth",8}";

        /// <inheritdoc/>
        public string Line(BenchTable table, BenchRow row) =>
            string.Format(CultureInfo.InvariantCulture, "{0,-20}{1,10}{2,7:F1}{3,9:F1}{4,12}{5,10:F3}{6,9}{7,8}{8,6:P0}{9,10:P1}{10,8}",
                row.Config.Title, row.Particles, row.NeighboursMean, row.CandidatesMean / row.NeighboursMean, row.Dispatches, row.Frame.Median,
                Short(SpeedUp(table, row, BenchSolver.ThesisCells)), Short(SpeedUp(table, row, BenchSolver.ThesisOctant)), row.Share(0),
                Roofline(row) / row.Frame.Median, Short(Growth(table, row)));

        static string Short(double value) => double.IsNaN(value) ? "" : value.ToString("F2", CultureInfo.InvariantCulture);

        // How many times faster than another solver at the same k; not a number where that was not measured.
        static double SpeedUp(BenchTable table, BenchRow row, BenchSolver than)
        {
            BenchRow other = table.Rows.FirstOrDefault(r => r.Config.Solver == than && r.Particles == row.Particles && r.SampleCount > 0);
            return other == null || than.SupportRatio != row.Config.Solver.SupportRatio ? double.NaN : other.Frame.Median / row.Frame.Median;
        }

        // Milliseconds at the device's copy speed.
        static double Roofline(BenchRow row) => 1e3 * StepBytes.Of(row) / row.CopySpeed;

        // Exponent of time over the number of particles; not a number with a single size.
        static double Growth(BenchTable table, BenchRow row)
        {
            var fit = new LineFit();
            foreach (BenchRow other in table.Rows)
            {
                bool near = other.Particles <= row.Particles && (long)GrowthSpan * other.Particles >= row.Particles;
                if (near && other.Config.Solver == row.Config.Solver && other.SampleCount > 0)
                    fit.Add(Math.Log(other.Particles), Math.Log(other.Frame.Median));
            }
            return fit.Slope;
        }
    }
}
