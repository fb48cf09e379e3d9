using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Steps alone of several methods: what they cost, against each other and against the memory's speed.</summary>
    public sealed class SolverLayout : BenchLayout
    {
        // Sizes of a growth exponent: the row's own and those down to a sixteenth of it.
        private const int GrowthSpan = 16;

        /// <summary>The form for some parts of a step.</summary>
        /// <param name="parts">Names of the parts, a column each.</param>
        public SolverLayout(IEnumerable<string> parts) : base("solver")
        {
            Format
                .Text("search", row => row.Config.Solver.Search)
                .Flag("neighbour_list", row => row.IsListed)
                .Count("triangles", row => row.Triangles)
                .Count("particles", row => row.Particles)
                .Number("spacing", row => row.Spacing)
                .Number("kappa", row => row.Config.Solver.SupportRatio)
                .Number("neighbours_mean", row => row.NeighboursMean)
                .Number("candidates_per_neighbour", row => row.CandidatesMean / row.NeighboursMean);
            Format.Count("steps", row => row.Config.Steps).Number("rebuilds", row => row.Rebuilds);
            AddTimes()
                .Number("mpsteps_per_s", row => row.MillionParticleSteps)
                .Number("mpairs_per_s", row => row.MillionParticleSteps * row.NeighboursMean)
                .Number("speedup_thesis_27", row => SpeedUp(row, BenchSolver.ThesisCells))
                .Number("speedup_thesis_27_fused", row => SpeedUp(row, BenchSolver.ThesisFused))
                .Number("speedup_thesis_8", row => SpeedUp(row, BenchSolver.ThesisOctant));
            AddParts("share.", parts, (row, i) => row.Share(i));
            Format
                .Number("blocks_over_step", row => row.BlocksOverStep)
                .Number("bytes_per_particle", row => (double)StepBytes.Of(row) / row.Particles)
                .Number("copy_gb_per_s", row => 1e-9 * row.CopySpeed)
                .Number("roofline_ms", Roofline)
                .Number("roofline_fraction", row => Roofline(row) / row.Frame.Median)
                .Number("growth_exponent", Growth);
            AddSamples();
        }

        /// <inheritdoc/>
        public override string Head =>
            $"{"",-20}{"particles",10}{"k",7}{"tests/k",9}{"dispatches",12}{"rebuilds",10}{"GPU ms",10}{"over 27",9}{"fused",8}" +
            $"{"over 8",8}{"sort",6}{"roofline",10}{"growth",8}";

        /// <inheritdoc/>
        public override string Line(BenchRow row) =>
            string.Format(CultureInfo.InvariantCulture,
                "{0,-20}{1,10}{2,7:F1}{3,9:F1}{4,12:G4}{5,10:G3}{6,10:F3}{7,9}{8,8}{9,8}{10,6:P0}{11,10:P1}{12,8}",
                row.Config.Title, row.Particles, row.NeighboursMean, row.CandidatesMean / row.NeighboursMean,
                (double)row.Dispatches / row.Config.Steps, row.Rebuilds, row.Frame.Median,
                Short(SpeedUp(row, BenchSolver.ThesisCells)), Short(SpeedUp(row, BenchSolver.ThesisFused)),
                Short(SpeedUp(row, BenchSolver.ThesisOctant)), row.Share(0),
                Roofline(row) / row.Frame.Median, Short(Growth(row)));

        // How many times faster than another solver at the same k; not a number where that was not measured.
        private static double SpeedUp(BenchRow row, BenchSolver than)
        {
            BenchRow other = row.Peers.FirstOrDefault(r => r.Config.Solver == than && r.Particles == row.Particles && r.IsMeasured);
            return other == null || than.SupportRatio != row.Config.Solver.SupportRatio ? double.NaN
                : other.Frame.Median / row.Frame.Median;
        }

        // Milliseconds at the device's copy speed.
        private static double Roofline(BenchRow row) => 1e3 * StepBytes.Of(row) / row.CopySpeed;

        // Exponent of time over the number of particles; not a number with a single size.
        private static double Growth(BenchRow row)
        {
            var fit = new LineFit();
            foreach (BenchRow other in row.Peers)
            {
                bool near = other.Particles <= row.Particles && (long)GrowthSpan * other.Particles >= row.Particles;
                if (near && other.Config.Name == row.Config.Name && other.IsMeasured)
                {
                    fit.Add(Math.Log(other.Particles), Math.Log(other.Frame.Median));
                }
            }
            return fit.Slope;
        }
    }
}
