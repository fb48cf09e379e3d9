using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Follows how many particles have another within half a spacing, and the largest density.</summary>
    public sealed class ParticleGapsMetric : CaseMetric
    {
        internal const string ErrorName = "particles within dx/2 of another, at the end";

        private readonly FluidSolverSettings settings;
        private readonly CaseSeries shares = new CaseSeries("share within dx/2");
        private double last = double.NaN, worst, nearest = 1.0, density;

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants.</param>
        public ParticleGapsMetric(in FluidSolverSettings settings) => this.settings = settings;

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            ParticleGaps gaps = ParticleGaps.Of(state.LocalPositions, settings.Spacing);
            last = gaps.CloseShare;
            worst = Math.Max(worst, last);
            nearest = Math.Min(nearest, gaps.Nearest);
            density = Math.Max(density, SnapshotStatistics.Of(state, settings).DensityErrorMax);
            shares.Add(time, last);
        }

        /// <summary>Share at the end; the largest of any sample; the nearest pair and the largest density error of any sample.</summary>
        public override IReadOnlyList<CaseError> Evaluate() => new[]
        {
            new CaseError(ErrorName, last),
            new CaseError("particles within dx/2 of another, largest", worst),
            new CaseError("nearest pair/dx", nearest),
            new CaseError("largest density error", density),
        };

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series() => new[] { shares };
    }
}
