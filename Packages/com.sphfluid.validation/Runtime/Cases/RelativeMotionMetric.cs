using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// How far particles moved from their places relative to their centre, over what rounding moves them: 1e-4 dx + 10 ulp of the
    /// largest coordinate that each has had. 1 is the limit.
    /// </summary>
    public sealed class RelativeMotionMetric : CaseMetric
    {
        internal const string ErrorName = "relative motion/(1e-4 dx + 10 ulp)";
        private const double Share = 1e-4;
        private const double Ulps = 10.0;

        private readonly double spacing;
        private readonly List<double> times = new List<double>();
        private readonly List<double> motions = new List<double>();
        private Vector3[] start;
        private float[] reach;
        private double worst, farthest;

        /// <summary>A metric for one run.</summary>
        /// <param name="spacing">dx [m].</param>
        public RelativeMotionMetric(double spacing) => this.spacing = spacing;

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            start ??= (Vector3[])state.LocalPositions.Clone();
            reach ??= new float[start.Length];
            double x = 0.0, y = 0.0, z = 0.0;
            for (int i = 0; i < start.Length; i++)
            {
                Vector3 p = state.LocalPositions[i];
                x += (double)p.x - start[i].x;
                y += (double)p.y - start[i].y;
                z += (double)p.z - start[i].z;
                reach[i] = Mathf.Max(reach[i], Mathf.Max(Mathf.Abs(p.x), Mathf.Max(Mathf.Abs(p.y), Mathf.Abs(p.z))));
            }
            x /= start.Length;
            y /= start.Length;
            z /= start.Length;
            double motion = 0.0;
            for (int i = 0; i < start.Length; i++)
            {
                Vector3 p = state.LocalPositions[i];
                double dx = (double)p.x - start[i].x - x, dy = (double)p.y - start[i].y - y, dz = (double)p.z - start[i].z - z;
                double moved = Math.Sqrt(dx * dx + dy * dy + dz * dz);
                motion = Math.Max(motion, moved);
                worst = Math.Max(worst, moved / (Share * spacing + Ulps * Ulp(reach[i])));
            }
            farthest = Math.Max(farthest, motion);
            times.Add(time);
            motions.Add(motion / spacing);
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseError> Evaluate() => new[]
        {
            new CaseError(ErrorName, start == null ? double.NaN : worst),
            new CaseError("relative motion/dx", start == null ? double.NaN : farthest / spacing),
        };

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new CaseSeries("relative motion/dx");
            for (int i = 0; i < times.Count; i++) series.Add(times[i], motions[i]);
            return new[] { series };
        }

        /// <summary>Distance to the next float: 2^-23 for 1 ≤ value &lt; 2.</summary>
        internal static double Ulp(float value) =>
            (double)BitConverter.Int32BitsToSingle(BitConverter.SingleToInt32Bits(Mathf.Abs(value)) + 1) - Mathf.Abs(value);
    }
}
