using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A ball of liquid of radius 1 m held by −ω² x, ω = 1/s, that swings between a long and a flat ellipsoid. No walls, no gravity, a
    /// pressure that is never negative: what is wrong here is the method's own pressure, surface, viscosity and step.
    /// </summary>
    public sealed class EllipsoidCase : ValidationCase
    {
        private const double Radius = 1.0;
        private const double Rate = 1.0;
        private const double Sigma = 0.5;
        private const double Duration = 6.0; // the second maximum is at 5.6
        private const double Interval = 0.05;
        private const double HalfDomain = 2.0;
        private const double SpeedLimit = 3.0;

        /// <inheritdoc/>
        public override string Name => "ellipsoid";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "drop" };

        /// <inheritdoc/>
        public override string LengthTitle => "the drop's radius";

        /// <inheritdoc/>
        public override string Title => "Oscillating ellipsoid";

        /// <inheritdoc/>
        public override string Source => "exact: a_i″ = −ω² a_i + λ/a_i, inviscid, p = 0 on the surface";

        /// <inheritdoc/>
        public override string ErrorName => EllipsoidMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("period, |T/T_exact − 1|", 0.0), ("second maximum over the exact one", 1.0) };

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t [1/ω]", "half axis along z over its start");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 8, 7.5);

        /// <summary>A ball <see cref="CaseParameters.Resolution"/> particles in radius; speeds are over ωR.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 3);
            List<Vector3> ball = CaseLattice.Ball(Radius, Radius / parameters.Resolution);
            // The cut lattice has about the ball's volume; scaled it has it exactly.
            double dx = Math.Pow(4.0 / 3.0 * Math.PI / ball.Count, 1.0 / 3.0) * Radius;
            float scale = (float)(dx * parameters.Resolution / Radius);
            for (int i = 0; i < ball.Count; i++) ball[i] *= scale;
            Vector3 domain = Vector3.one * (float)(2.0 * HalfDomain * Radius);
            CaseLattice.Jitter(ball, parameters.Jitter * dx, parameters.Seed, 0.5f * domain);
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, Rate * Radius, Vector3.zero);
            settings.BodyForce = new FluidBodyForce { RateSquared = Vector3.one * (float)(Rate * Rate) };
            return new CaseSetup
            {
                Settings = settings,
                Particles = CaseLattice.Particles(ball, p => (float)Sigma * new Vector3(-0.5f * p.x, -0.5f * p.y, p.z)),
                Duration = Duration / Rate,
                SampleInterval = Interval / Rate,
                IsOpen = true,
                SpeedLimit = SpeedLimit * Rate * Radius,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new EllipsoidMetric(new EllipsoidMotion(Sigma / Rate, Rate * (setup.Duration + setup.Settings.TimeStep)), Rate);
    }
}
