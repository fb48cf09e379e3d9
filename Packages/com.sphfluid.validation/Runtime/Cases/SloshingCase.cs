using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A quarter of a cubic metre of liquid stands against one wall of a cube of 1 m, falls, and sloshes for 6 s. Places of particles
    /// are what the case looks at: two within half a spacing stand for a volume that is then missing elsewhere, and jolt what they are
    /// pressed into.
    /// </summary>
    public sealed class SloshingCase : ValidationCase
    {
        private const double Edge = 1.0;
        private const double Gravity = 9.81;
        private const double Duration = 6.0;
        private const double Interval = 0.1;

        /// <inheritdoc/>
        public override string Name => "sloshing";

        /// <inheritdoc/>
        public override string Title => "Sloshing";

        /// <inheritdoc/>
        public override string Source => "particles that share a place stand for too much";

        /// <inheritdoc/>
        public override string ErrorName => ParticleGapsMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 5e-4;

        /// <summary>Four times the cube of 16: 16,384 particles.</summary>
        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 10.0);

        /// <summary>4 <see cref="CaseParameters.Resolution"/>³ particles; speeds are over √(2 g H).</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 3);
            int n = parameters.Resolution;
            FluidParticle[] block = BenchLiquid.Block(4 * n * n * n, false, out float dx, out float height);
            var positions = new List<Vector3>();
            foreach (FluidParticle particle in block) positions.Add(particle.Position);
            Vector3 domain = Vector3.one * (float)Edge;
            CaseLattice.Jitter(positions, parameters.Jitter * dx, parameters.Seed, 0.4999f * domain);
            double speed = Math.Sqrt(2.0 * Gravity * height);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f)),
                Particles = CaseLattice.Particles(positions),
                Duration = Duration,
                SampleInterval = Interval,
                SpeedLimit = 4.0 * speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new ParticleGapsMetric(setup.Settings);
    }
}
