using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A drop of water, 1 cm in radius, that is a tenth longer along z than its volume's ball, swings by its surface tension alone: no
    /// gravity, no walls.
    /// </summary>
    public sealed class CapillaryDropCase : ValidationCase
    {
        private const double Radius = 0.01, Tension = 0.072;
        private const double Longer = 0.1;
        private const double Periods = 2.5;
        private const double SamplesPerPeriod = 40.0;
        private const double HalfDomain = 2.5; // over the radius

        /// <inheritdoc/>
        public override string Name => "capillary-drop";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "capillary", "tension" };

        /// <inheritdoc/>
        public override string LengthTitle => "the drop's radius";

        /// <inheritdoc/>
        public override string Title => "A drop swings by its surface tension";

        /// <inheritdoc/>
        public override string Source =>
            "exact for small swings: Lamb, Hydrodynamics, § 275; J. Tsamopoulos and R. Brown 1983, J. Fluid Mech. 127, 519";

        /// <inheritdoc/>
        public override string ErrorName => CapillaryDropMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("damping beyond the set viscosity's over the frequency", 0.0), ("radius at the end over the start's − 1", 0.0) };

        /// <summary>A swing of a tenth of the radius is slower than a small one by about its square.</summary>
        /// <inheritdoc/>
        public override double Floor => 0.01;

        /// <inheritdoc/>
        public override string FloorSource => "the reference's own, as Lamb's swing is a small one";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t over Lamb's period", "length against breadth over the start's");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 8, 10.0);

        /// <summary>Balls <see cref="CaseParameters.Resolution"/> particles in radius; speeds are over ωR.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 4);
            if (!parameters.Method.HasTension)
            {
                throw new ArgumentException($"{Name}: the method {parameters.Method.Name} has no surface tension.");
            }
            List<Vector3> ball = CaseLattice.Ball(Radius, Radius / parameters.Resolution);
            double dx = Math.Pow(4.0 / 3.0 * Math.PI / ball.Count, 1.0 / 3.0) * Radius, scale = dx * parameters.Resolution / Radius;
            // Along z by 1 + ε, across by its root: the volume stays.
            var shape = new Vector3((float)(scale / Math.Sqrt(1.0 + Longer)), (float)(scale / Math.Sqrt(1.0 + Longer)),
                (float)(scale * (1.0 + Longer)));
            for (int i = 0; i < ball.Count; i++) ball[i] = Vector3.Scale(shape, ball[i]);
            var domain = (float)(2.0 * HalfDomain * Radius) * Vector3.one;
            double speed = CapillaryDropMetric.FrequencyOf(Tension, 1000.0 * 4.0 / 3.0 * Math.PI * Radius * Radius * Radius) * Radius;
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, speed, Vector3.zero, tension: Tension);
            CaseLattice.Jitter(ball, parameters.Jitter * dx, parameters.Seed, 0.5f * domain);
            double period = 2.0 * Math.PI / CapillaryDropMetric.FrequencyOf(Tension, Mass(settings, ball.Count));
            return new CaseSetup
            {
                Settings = settings,
                Particles = CaseLattice.Particles(ball),
                Duration = Periods * period,
                SampleInterval = period / SamplesPerPeriod,
                IsOpen = true,
                SpeedLimit = 10.0 * speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new CapillaryDropMetric(Tension,
            Mass(setup.Settings, setup.Particles.Length), setup.Settings.Viscosity / setup.Settings.RestDensity, Radius);

        private static double Mass(in FluidSolverSettings settings, int particles) => particles * (double)settings.ParticleMass;
    }
}
