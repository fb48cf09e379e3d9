using System;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>States made by hand, for metrics.</summary>
    internal static class WallCaseStates
    {
        /// <summary>A state whose particles have the positions, velocities, densities and pressures of functions of their number.</summary>
        public static FluidSnapshot State(int count, Func<int, Vector3> position, Func<int, Vector3> velocity = null,
            Func<int, double> density = null, Func<int, double> pressure = null)
        {
            var particles = new FluidParticle[count];
            var densities = new float[count];
            var pressures = new float[count];
            for (int i = 0; i < count; i++)
            {
                particles[i] = new FluidParticle(position(i), velocity == null ? Vector3.zero : velocity(i), (uint)i);
                densities[i] = density == null ? 1000f : (float)density(i);
                pressures[i] = pressure == null ? 0f : (float)pressure(i);
            }
            return FluidSnapshot.FromParticles(particles, densities, pressures, Matrix4x4.identity);
        }

        /// <summary>The error of a name.</summary>
        public static double Named(CaseMetric metric, string name)
        {
            foreach (CaseError error in metric.Evaluate())
            {
                if (error.Name == name) return error.Value;
            }
            throw new ArgumentException($"There is no error '{name}'.", nameof(name));
        }
    }
}
