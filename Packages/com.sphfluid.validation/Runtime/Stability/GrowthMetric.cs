using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Measures whether a small disturbance outgrows the time step. What diverges beyond a limit of the step changes its sign each step, so
    /// the sixth difference of the positions over 2⁶ is its amplitude, while of a wave that grows by a fifth a step, as unequal kernels
    /// make it, a millionth is left. It is compared with the first second difference over 2². Sample every step.
    /// </summary>
    public sealed class GrowthMetric : CaseMetric
    {
        private const int First = 2, Order = 6;

        private readonly double factor;
        private readonly Vector3 period;
        private readonly Queue<double3[]> displacements = new Queue<double3[]>(); // the last ones, from sample to sample
        private Vector3[] last;
        private double start = double.NaN;

        /// <summary>A metric of one run.</summary>
        /// <param name="factor">Growth that no bounded motion has.</param>
        /// <param name="period">Length of the domain along periodic axes [m]; zero along the others.</param>
        public GrowthMetric(double factor, Vector3 period)
        {
            this.factor = factor;
            this.period = period;
        }

        /// <summary>Amplitude of what alternates over that of the first steps.</summary>
        public double Growth { get; private set; } = double.NaN;

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            Vector3[] now = state.LocalPositions;
            if (last != null) displacements.Enqueue(Displacements(now));
            last = now;
            if (displacements.Count == First && double.IsNaN(start)) start = Amplitude();
            if (displacements.Count < Order) return;
            Growth = Amplitude() / start;
            displacements.Dequeue();
            if (!(Growth <= factor))
            {
                Failure = FormattableString.Invariant($"what alternates from step to step grew to {Growth:G3} of the start's");
            }
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseError> Evaluate() =>
            new[] { new CaseError("growth of what alternates from step to step", Growth) };

        // Root mean square of the highest difference that the steps give, over 2 to its order [m].
        private double Amplitude()
        {
            double3[][] differences = displacements.ToArray();
            int count = last.Length, order = differences.Length;
            double squares = 0.0;
            for (int i = 0; i < count; i++)
            {
                double3 sum = double3.zero;
                double binomial = 1.0; // of order − 1 over k: differences of the displacements
                for (int k = 0; k < order; k++)
                {
                    sum += ((k & 1) == 0 ? binomial : -binomial) * differences[k][i];
                    binomial = binomial * (order - 1 - k) / (k + 1);
                }
                squares += math.dot(sum, sum);
            }
            return Math.Sqrt(squares / Math.Max(1, count)) / Math.Pow(2.0, order);
        }

        // The shortest ones, across a periodic face where that is shorter.
        private double3[] Displacements(Vector3[] now)
        {
            var result = new double3[now.Length];
            for (int i = 0; i < now.Length; i++)
            {
                Vector3 d = now[i] - last[i];
                for (int axis = 0; axis < 3; axis++)
                {
                    if (period[axis] > 0f) d[axis] -= period[axis] * Mathf.Round(d[axis] / period[axis]);
                }
                result[i] = (float3)d;
            }
            return result;
        }
    }
}
