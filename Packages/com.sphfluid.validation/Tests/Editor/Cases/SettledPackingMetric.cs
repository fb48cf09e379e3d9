using System;
using System.Collections.Generic;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the sums of a column at rest make of a vertical gradient: M = Σ_j m/ρ_j y² (−W'/r) of the particles as they lie, over the rest
    /// lattice's M by which the method Standard divides its forces, in the mean over the particles that the slope of the pressure is fitted
    /// to. Two particles push with p_i/ρ_i² + p_j/ρ_j², so a plane between them bears M times the pressure that they read.
    /// </summary>
    internal sealed class SettledPackingMetric : CaseMetric
    {
        private readonly FluidSolverSettings settings;
        private readonly double begin;
        private double sum, across;
        private long count;

        public SettledPackingMetric(in FluidSolverSettings settings, double begin)
        {
            this.settings = settings;
            this.begin = begin;
        }

        /// <summary>Along y.</summary>
        public double Moment => sum / count;

        /// <summary>In the mean of x and z.</summary>
        public double MomentAcross => across / count;

        public override void Sample(double time, FluidSnapshot state)
        {
            if (time < begin) return;
            double radius = settings.SupportRadius, edge = 3.0 * settings.Spacing, floor = -0.5 * settings.DomainSize.y,
                top = double.MinValue;
            foreach (Vector3 position in state.LocalPositions) top = Math.Max(top, position.y);
            double factor = Slope(radius) * settings.ParticleMass / LatticeMoment(settings.SupportRadius / settings.Spacing);
            Vector3 period = settings.PeriodLength;
            for (int i = 0; i < state.Count; i++)
            {
                Vector3 at = state.LocalPositions[i];
                if (at.y - floor < edge || top - at.y < edge) continue;
                count++;
                for (int j = 0; j < state.Count; j++)
                {
                    Vector3 d = state.LocalPositions[j] - at;
                    if (Math.Abs(d.y) >= radius) continue;
                    for (int axis = 0; axis < 3; axis++)
                    {
                        d[axis] -= period[axis] > 0f ? period[axis] * Mathf.Round(d[axis] / period[axis]) : 0f;
                    }
                    double push = factor * Math.Pow(Math.Max(0.0, 1.0 - d.magnitude / radius), 3.0) / state.Densities[j];
                    sum += push * d.y * d.y;
                    across += 0.5 * push * ((double)d.x * d.x + (double)d.z * d.z);
                }
            }
        }

        // Of the simple cubic lattice with dx = 1, over the kernel's own sum.
        private static double LatticeMoment(double radius)
        {
            int reach = (int)Math.Ceiling(radius);
            double moment = 0.0, kernels = 0.0;
            for (int z = -reach; z <= reach; z++)
                for (int y = -reach; y <= reach; y++)
                    for (int x = -reach; x <= reach; x++)
                    {
                        double q = Math.Min(1.0, Math.Sqrt(x * x + y * y + z * z) / radius);
                        moment += Slope(radius) * Math.Pow(1.0 - q, 3.0) * y * y;
                        kernels += CpuKernels.Wendland(q) / Math.Pow(radius, 3.0);
                    }
            return moment / kernels;
        }

        // −W'/r of Wendland's C2 kernel is this (1 − q)³.
        private static double Slope(double radius) => 210.0 / (Math.PI * Math.Pow(radius, 5.0));

        public override IReadOnlyList<CaseError> Evaluate() =>
            new[] { new CaseError("moment", Moment), new CaseError("moment across", MomentAcross) };
    }
}
