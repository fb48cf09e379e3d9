using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Lattices, jitter and constants of the failure experiments. Spacing 0.1 m, c_eff 10 m/s, no gravity unless said.</summary>
    internal static class FailureBlocks
    {
        public const float Spacing = 0.1f;
        public const float Sound = 10f;

        /// <summary>Constants by rule for c_eff = <see cref="Sound"/>, all guards of the corrected form on.</summary>
        public static FluidSolverSettings Settings(Vector3 domain, float ratio = 2f, FluidAxes periodic = FluidAxes.None,
            float spacing = Spacing)
        {
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = domain;
            input.Spacing = spacing;
            input.SupportRatio = ratio;
            input.Gravity = Vector3.zero;
            input.MinSpeed = 0.2f * Sound;
            input.SoundSpeedRatio = 5f;
            input.MaxCompression = 1f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.OctantSearch = false; // the same pairs, faster
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        /// <summary>A lattice that fills a periodic box, jittered; its constants have viscosity and walls as by rule.</summary>
        public static FailureRun PeriodicBox(Vector3Int counts, float ratio, double jitter, float spacing = Spacing)
        {
            Vector3 domain = spacing * (Vector3)counts;
            return new FailureRun
            {
                Settings = Settings(domain, ratio, FluidAxes.All, spacing),
                Start = Lattice(counts, spacing, -0.5f * domain, jitter * spacing, 0.5f * domain),
            };
        }

        /// <summary>
        /// A column from the floor up to 0.8 of its box, as its own weight compresses it; constants by rule but for the speed of sound and
        /// three times the viscosity, so that it is soon at rest.
        /// </summary>
        /// <param name="counts">Particles along each axis.</param>
        /// <param name="gravity">g [m/s²].</param>
        /// <param name="ratio">m = c²/gH.</param>
        /// <param name="periodic">Axes without walls; along them the column fills the box, as along the others.</param>
        /// <param name="support">κ.</param>
        public static FailureRun Column(Vector3Int counts, float gravity, double ratio, FluidAxes periodic, float support = 2f)
        {
            Vector3 domain = Spacing * new Vector3(counts.x, 1.25f * counts.y, counts.z);
            double height = counts.y * Spacing, fall = Math.Sqrt(2.0 * gravity * height);
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = domain;
            input.Spacing = Spacing;
            input.Gravity = new Vector3(0f, -gravity, 0f);
            input.MinSpeed = (float)fall;
            input.SoundSpeedRatio = (float)(Math.Sqrt(ratio * gravity * height) / fall);
            input.MaxCompression = 1e6f; // c by the ratio alone
            input.ViscosityRatio *= 3f;
            input.SupportRatio = support;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.OctantSearch = false;
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] start = Lattice(counts, Spacing, -0.5f * domain, 0.01 * Spacing, 0.5f * domain);
            for (int i = 0; i < start.Length; i++)
            {
                double above = height - (start[i].Position.y + 0.5 * domain.y); // of liquid, as a lattice
                start[i].Position.y =
                    (float)(-0.5 * domain.y + ratio * height * (Math.Log(1.0 + 1.0 / ratio) - Math.Log(1.0 + above / (ratio * height))));
            }
            return new FailureRun { Settings = settings, Start = start };
        }

        /// <summary>
        /// A block of particles; the jitter is normal, and nothing leaves the box of half size <paramref name="inside"/>.
        /// </summary>
        public static FluidParticle[] Lattice(Vector3Int counts, float spacing, Vector3 corner, double jitter, Vector3 inside, int seed = 1)
        {
            var positions = CaseLattice.Box(counts, spacing, corner);
            CaseLattice.Jitter(positions, jitter, seed, inside);
            return CaseLattice.Particles(positions);
        }

        /// <summary>One block after another, numbered through.</summary>
        public static FluidParticle[] Join(params FluidParticle[][] blocks)
        {
            int count = 0;
            foreach (FluidParticle[] block in blocks) count += block.Length;
            var all = new FluidParticle[count];
            int at = 0;
            foreach (FluidParticle[] block in blocks)
            {
                foreach (FluidParticle particle in block)
                {
                    all[at] = particle;
                    all[at].Id = (uint)at++;
                }
            }
            return all;
        }

        /// <summary>The same particles with a velocity by position.</summary>
        public static FluidParticle[] Moving(FluidParticle[] particles, Func<Vector3, Vector3> velocity) =>
            Array.ConvertAll(particles, p => new FluidParticle(p.Position, velocity(p.Position), p.Id));

        /// <summary>Step of dt √k/R = <paramref name="courant"/>; the emergency limit follows it.</summary>
        public static void SetCourant(ref FluidSolverSettings settings, double courant)
        {
            settings.TimeStep = (float)(courant * settings.SupportRadius / Math.Sqrt(settings.Own<ThesisSettings>().Stiffness));
            float limit = ThesisRules.EmergencyLimit(settings.Spacing, settings.TimeStep);
            settings = settings.WithOwn((ref ThesisSettings own) => own.AccelerationLimit = limit);
        }

        /// <summary>Viscosity of a kinematic viscosity [m²/s].</summary>
        public static void SetKinematic(ref FluidSolverSettings settings, double kinematic) =>
            settings.Viscosity = (float)(kinematic * settings.RestDensity);
    }
}
