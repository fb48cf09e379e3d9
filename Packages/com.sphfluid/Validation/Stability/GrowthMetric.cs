using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Tells whether a small disturbance grows: a run fails when v_rms is a number of times the start's.</summary>
    public sealed class GrowthMetric : CaseMetric
    {
        readonly double factor;
        double first = double.NaN;

        /// <summary>A metric of one run.</summary>
        /// <param name="factor">Growth that no bounded motion has.</param>
        public GrowthMetric(double factor) => this.factor = factor;

        /// <summary>v_rms over the start's.</summary>
        public double Growth { get; private set; } = 1.0;

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double squares = 0.0;
            foreach (Vector3 v in state.Velocities)
                squares += new Vector3d(v).Dot(new Vector3d(v));
            double rms = Math.Sqrt(squares / Math.Max(1, state.Count));
            if (double.IsNaN(first))
                first = rms;
            Growth = rms / first;
            if (!(Growth <= factor))
                Failure = FormattableString.Invariant($"v_rms grew to {Growth:G3} of the start's");
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseError> Evaluate() => new[] { new CaseError("growth of v_rms", Growth) };
    }
}
