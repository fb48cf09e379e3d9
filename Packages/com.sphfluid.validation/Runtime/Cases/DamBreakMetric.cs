using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Follows the front on the floor and the height at the closed end, and holds them against <see cref="MartinMoyce"/>. The
    /// closed end is the domain's low face of x, the floor the low face of y. The height is given a second time without what is
    /// next to the wall: a method that lets particles stick there has a film on it that stands above the liquid.
    /// </summary>
    public sealed class DamBreakMetric : CaseMetric
    {
        /// <summary>The front is sought among particles less than this high over the floor, over dx.</summary>
        public const double FloorBand = 3.0;

        /// <summary>
        /// The height is that of particles less than this far from the closed end, over dx; a film on the wall is nearer too.
        /// </summary>
        public const double EndBand = 2.0;

        /// <summary>
        /// The height beside the film is that of particles from <see cref="EndBand"/> to this far from the closed end, over dx.
        /// </summary>
        public const double BesideBand = 6.0;

        /// <summary>Largest time shift that counts, in T.</summary>
        public const double LargestShift = 0.5;

        /// <summary>Last τ at which heights are compared: later the sheet at the closed end is a few spacings thick.</summary>
        public const double LastHeightTime = 2.45;

        internal const string ErrorName = "front, shifted RMS", RawName = "front, raw RMS";

        // T = 0.41 is left out: the gate has hardly left. The slope is that of the steady part, T ≥ 1.43.
        private const int FirstPoint = 1, FirstSlopePoint = 3;

        private static readonly SearchRange shifts = new SearchRange("dam-break", "the front's shift in T", -LargestShift, LargestShift,
            "A run so far from the experiment is wrong, or the range in DamBreakMetric too narrow: look at its front.");

        private readonly FluidSolverSettings settings;
        private readonly double width;
        private readonly int slabRows;
        private readonly SampledCurve front = new SampledCurve();
        private readonly SampledCurve height = new SampledCurve();
        private readonly SampledCurve beside = new SampledCurve();
        private readonly List<double> distances = new List<double>();

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants; gravity along −y.</param>
        /// <param name="width">Width a of the column [m].</param>
        /// <param name="slabRows">Particles across the slab, along z.</param>
        public DamBreakMetric(in FluidSolverSettings settings, double width, int slabRows)
        {
            this.settings = settings;
            this.width = width;
            this.slabRows = slabRows;
        }

        private double ClockRate => Math.Sqrt(-settings.Gravity.y / width);

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            front.Add(time * ClockRate * Math.Sqrt(2.0), Reach(state, 0, 1, double.NegativeInfinity, FloorBand, slabRows) / width);
            height.Add(time * ClockRate, Reach(state, 1, 0, double.NegativeInfinity, EndBand, slabRows * EndBand) / (2.0 * width));
            beside.Add(time * ClockRate, Reach(state, 1, 0, EndBand, BesideBand, slabRows * (BesideBand - EndBand)) / (2.0 * width));
        }

        /// <summary>
        /// RMS of the relative error of Z over 0.84 ≤ T ≤ 3.33, after one time shift within ±0.5 in T and without; the shift,
        /// negative where the run is ahead of the experiment; the error of the slope dZ/dT over 1.43 ≤ T ≤ 3.33, shifted;
        /// the largest error of the height for τ ≤ 2.45, not shifted, at the wall and beside what sticks to it.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double shift = TimeShiftFit.Best(front, MartinMoyce.FrontTimes, MartinMoyce.Fronts, FirstPoint, shifts);
            return new[]
            {
                new CaseError(ErrorName, Rms(shift)),
                new CaseError(RawName, Rms(0.0)),
                new CaseError("front, shift in T", shift),
                new CaseError("front, slope dZ/dT − 1", Slope(shift)),
                new CaseError("height, largest error", LargestError(height)),
                new CaseError("height beside the wall's film, largest error", LargestError(beside)),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var fronts = new CaseSeries("Z, Martin and Moyce", true);
            for (int i = 0; i < MartinMoyce.Fronts.Length; i++) fronts.Add(MartinMoyce.FrontTimes[i], MartinMoyce.Fronts[i]);
            var heights = new CaseSeries("h, Martin and Moyce", true);
            for (int i = 0; i < MartinMoyce.Heights.Length; i++)
            {
                heights.Add(MartinMoyce.HeightTimes[i] * Math.Sqrt(2.0), MartinMoyce.Heights[i]);
            }
            var result = new List<CaseSeries> { fronts, heights, front.ToSeries("Z, raw", 1.0, 0.0) };
            if (TimeShiftFit.TryBest(front, MartinMoyce.FrontTimes, MartinMoyce.Fronts, FirstPoint, shifts, out double shift))
            {
                result.Add(front.ToSeries(FormattableString.Invariant($"Z, shifted by {-shift:+0.00;-0.00;0.00}"), 1.0, -shift));
            }
            result.Add(height.ToSeries("h", Math.Sqrt(2.0), 0.0));
            return result;
        }

        // How far liquid reaches from the low face of one axis, of the particles in a band at the low face of another [m].
        private double Reach(FluidSnapshot state, int along, int near, double from, double to, double row)
        {
            Vector3 low = -0.5f * settings.DomainSize;
            distances.Clear();
            foreach (Vector3 position in state.LocalPositions)
            {
                double depth = ((double)position[near] - low[near]) / settings.Spacing;
                if (depth >= from && depth < to) distances.Add((double)position[along] - low[along]);
            }
            return LiquidReach.Of(distances, (int)row, settings.Spacing).Edge;
        }

        private double Rms(double shift) => TimeShiftFit.RelativeRms(front, MartinMoyce.FrontTimes, MartinMoyce.Fronts, FirstPoint, shift);

        private double Slope(double shift)
        {
            LineFit run = new LineFit(), experiment = new LineFit();
            for (int i = FirstSlopePoint; i < MartinMoyce.Fronts.Length; i++)
            {
                run.Add(MartinMoyce.FrontTimes[i], front.At(MartinMoyce.FrontTimes[i] + shift));
                experiment.Add(MartinMoyce.FrontTimes[i], MartinMoyce.Fronts[i]);
            }
            return run.Slope / experiment.Slope - 1.0;
        }

        private static double LargestError(SampledCurve height)
        {
            double largest = 0.0;
            for (int i = 0; i < MartinMoyce.Heights.Length && MartinMoyce.HeightTimes[i] <= LastHeightTime; i++)
            {
                double error = Math.Abs(height.At(MartinMoyce.HeightTimes[i]) - MartinMoyce.Heights[i]);
                largest = Math.Max(largest, error);
            }
            return largest;
        }
    }
}
