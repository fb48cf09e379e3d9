using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>
    /// Averages a column at rest over the end of its run: pressure over depth, height, what still moves, density. Layers of
    /// three spacings at the surface and at the floor are left out of pressure and density.
    /// </summary>
    public sealed class HydrostaticMetric : CaseMetric
    {
        /// <summary>Spacings left out at the surface and at the floor.</summary>
        public const double LeftOut = 3.0;

        internal const string ErrorName = "slope of the pressure over depth";

        readonly FluidSolverSettings settings;
        readonly double depth, gravity, begin;
        readonly int layer;
        readonly LineFit line = new LineFit();
        readonly double[] binSums;
        readonly int[] binCounts;
        double heights, speedSquares, densityErrors;
        int samples;
        long particles;

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants; gravity along −y, the floor is the domain's lower face.</param>
        /// <param name="depth">Height H of the column at rest density [m].</param>
        /// <param name="layer">Particles in a horizontal layer.</param>
        /// <param name="begin">Time from which it is averaged [s].</param>
        public HydrostaticMetric(in FluidSolverSettings settings, double depth, int layer, double begin)
        {
            this.settings = settings;
            this.depth = depth;
            this.layer = layer;
            this.begin = begin;
            gravity = -settings.Gravity.y;
            int bins = Math.Max(1, (int)Math.Round(depth / settings.Spacing));
            binSums = new double[bins];
            binCounts = new int[bins];
        }

        /// <summary>Height ratio h/H of a liquid of p = c² (ρ − ρ0) at rest, c² = m g H: m ln(1 + 1/m).</summary>
        /// <param name="m">c²/(g H).</param>
        public static double HeightRatio(double m) => m * Math.Log(1.0 + 1.0 / m);

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double dx = settings.Spacing;
            double floor = -0.5 * settings.DomainSize.y;
            double height = SurfaceHeight(state, floor);
            if (!(height > (2.0 * LeftOut + 2.0) * dx))
                Failure = FormattableString.Invariant($"the column has sunk to {height / dx:0.#} dx of height; nothing is left to measure");
            if (time < begin || Failure != null)
                return;
            samples++;
            heights += height;
            for (int i = 0; i < state.Count; i++)
            {
                speedSquares += state.Velocities[i].sqrMagnitude;
                double above = state.LocalPositions[i].y - floor;
                double below = height - above;
                int bin = (int)Math.Floor(below / dx);
                if (bin >= 0 && bin < binSums.Length)
                {
                    binSums[bin] += state.Pressures[i];
                    binCounts[bin]++;
                }
                if (above < LeftOut * dx || below < LeftOut * dx)
                    continue;
                line.Add(below, state.Pressures[i]);
                densityErrors += Math.Abs(state.Densities[i] / (double)settings.RestDensity - 1.0);
            }
            particles += state.Count;
        }

        /// <summary>
        /// |slope/(ρ g) − 1| of the pressure as it is read; the slope itself, as read and as it pushes (half of it with the ½ of
        /// the thesis's equation (13)); height lost beyond the equation of state's; v_rms/√(gH); mean |ρ/ρ0 − 1|.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double slope = line.Slope / (settings.RestDensity * gravity);
            double m = (double)settings.SoundSpeed * settings.SoundSpeed / (gravity * depth);
            double height = heights / samples / depth;
            return new[]
            {
                new CaseError(ErrorName, Math.Abs(slope - 1.0)),
                new CaseError("slope/(ρg), as read", slope),
                new CaseError("slope/(ρg), as it pushes", settings.PressureHalf ? 0.5 * slope : slope),
                new CaseError("height lost beyond the equation of state's", HeightRatio(m) - height),
                new CaseError("v_rms/√(gH)", Math.Sqrt(speedSquares / particles / (gravity * depth))),
                new CaseError("mean |ρ/ρ0 − 1|", densityErrors / line.Count),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            double unit = settings.RestDensity * gravity * depth;
            double bin = depth / binSums.Length;
            var exact = new CaseSeries("ρ g d", true);
            exact.Add(0.0, 0.0);
            exact.Add(1.0, 1.0);
            var read = new CaseSeries("pressure as read");
            var pushes = new CaseSeries("pressure as it pushes");
            for (int b = 0; b < binSums.Length; b++)
            {
                if (binCounts[b] == 0)
                    continue;
                double pressure = binSums[b] / binCounts[b] / unit;
                read.Add((b + 0.5) * bin / depth, pressure);
                pushes.Add((b + 0.5) * bin / depth, 0.5 * pressure);
            }
            return settings.PressureHalf ? new[] { exact, read, pushes } : new[] { exact, read };
        }

        // Half a spacing above the median of the highest layer's worth of particles: a few that fly do not count.
        double SurfaceHeight(FluidSnapshot state, double floor)
        {
            var heights = new double[state.Count];
            for (int i = 0; i < heights.Length; i++)
                heights[i] = state.LocalPositions[i].y - floor;
            Array.Sort(heights);
            int count = Math.Min(layer, heights.Length);
            int first = heights.Length - count;
            double median = 0.5 * (heights[first + (count - 1) / 2] + heights[first + count / 2]);
            return median + 0.5 * settings.Spacing;
        }
    }
}
