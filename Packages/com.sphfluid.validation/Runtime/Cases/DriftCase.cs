using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A block of liquid drifts without gravity: by Galileo it does what a block at rest does, nothing.</summary>
    public sealed class DriftCase : ValidationCase
    {
        private const float Edge = 0.3f;
        private const float Path = 1f;
        private const float Margin = 0.25f;
        private const float Speed = 2f;
        private const int Samples = 8;

        /// <inheritdoc/>
        public override string Name => "drift";

        /// <inheritdoc/>
        public override string Title => "Drift";

        /// <inheritdoc/>
        public override string Source => "exact: nothing moves relative to anything";

        /// <inheritdoc/>
        public override string ErrorName => RelativeMotionMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 1.0;

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 7, 5.0, jitter: 0.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 3);
            double dx = Edge / parameters.Resolution;
            var domain = new Vector3(Edge + Path + 2f * Margin, Edge + 2f * Margin, Edge + 2f * Margin);
            Vector3 corner = new Vector3(Margin - 0.5f * domain.x, -0.5f * Edge, -0.5f * Edge);
            List<Vector3> block = CaseLattice.Box(Vector3Int.one * parameters.Resolution, dx, corner);
            FluidParticle[] particles = CaseLattice.Particles(block);
            for (int i = 0; i < particles.Length; i++)
            {
                particles[i] = new FluidParticle(particles[i].Position, Speed * Vector3.right, particles[i].Id);
            }

            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, Speed, Vector3.zero),
                Particles = particles,
                Duration = Path / Speed,
                SampleInterval = Path / Speed / Samples,
                IsOpen = true,
                SpeedLimit = 3.0 * Speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new RelativeMotionMetric(setup.Settings.Spacing);
    }
}
