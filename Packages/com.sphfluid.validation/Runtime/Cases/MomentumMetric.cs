using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Change of the sum of momenta over the sum of their sizes at the start; all particles have one mass.</summary>
    public sealed class MomentumMetric : CaseMetric
    {
        internal const string ErrorName = "|ΣΔmv|/Σm|v|";

        private readonly List<double> times = new List<double>();
        private readonly List<double> drifts = new List<double>();
        private double startX, startY, startZ, scale, worst;

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double x = 0.0, y = 0.0, z = 0.0, sizes = 0.0;
            foreach (Vector3 v in state.Velocities)
            {
                x += v.x;
                y += v.y;
                z += v.z;
                sizes += Math.Sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
            }
            if (times.Count == 0) (startX, startY, startZ, scale) = (x, y, z, sizes);
            double dx = x - startX, dy = y - startY, dz = z - startZ;
            double drift = Math.Sqrt(dx * dx + dy * dy + dz * dz) / scale;
            worst = Math.Max(worst, drift);
            times.Add(time);
            drifts.Add(drift);
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseError> Evaluate() => new[] { new CaseError(ErrorName, scale > 0.0 ? worst : double.NaN) };

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new CaseSeries(ErrorName);
            for (int i = 0; i < times.Count; i++) series.Add(times[i], drifts[i]);
            return new[] { series };
        }
    }
}
