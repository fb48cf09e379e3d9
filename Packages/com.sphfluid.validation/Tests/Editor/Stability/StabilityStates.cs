using System;
using System.Linq;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Made-up states of a column of 4 × 10 × 4 particles on the floor of a domain of 0.8 × 2 × 0.8 m, dx = 0.1 m.</summary>
    internal static class StabilityStates
    {
        public const int Count = 160;

        public static FluidSolverSettings Settings => new FluidSolverSettings
        {
            DomainSize = new Vector3(0.8f, 2f, 0.8f), Spacing = 0.1f, SupportRadius = 0.2f, RestDensity = 1000f, ParticleMass = 1f,
            PressureClamp = true, TimeStep = 0.001f, Gravity = new Vector3(0f, -10f, 0f),
        }.WithOwn(new ThesisSettings { Stiffness = 200f, PressureHalf = true });

        /// <summary>c_eff = 10 m/s, H = 1 m: m = c²/(gH) = 10.</summary>
        public static StabilityScenario Scenario =>
            new StabilityScenario { Setup = new CaseSetup { Settings = Settings }, ReferenceSpeed = 4.0, SettledFrom = 0.5 };

        /// <summary>The column with something done to each particle.</summary>
        public static FluidSnapshot Column(Func<int, FluidParticle, FluidParticle> change = null, float density = 1000f)
        {
            var particles = new FluidParticle[Count];
            for (int i = 0; i < Count; i++)
            {
                var place = new Vector3(-0.15f + 0.1f * (i % 4), -0.95f + 0.1f * (i / 16), -0.15f + 0.1f * (i / 4 % 4));
                particles[i] = new FluidParticle(place, Vector3.zero, (uint)i);
                if (change != null) particles[i] = change(i, particles[i]);
            }
            return FluidSnapshot.FromParticles(particles, Enumerable.Repeat(density, Count).ToArray(), new float[Count],
                Matrix4x4.identity);
        }

        public static FluidParticle At(FluidParticle particle, Vector3 position, Vector3 velocity) =>
            new FluidParticle(position, velocity, particle.Id);
    }
}
