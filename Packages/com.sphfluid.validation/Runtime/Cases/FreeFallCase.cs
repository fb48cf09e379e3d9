using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A block of liquid falls 1.5 m without touching anything. What falls freely feels no weight: its particles keep their places to
    /// each other. A density that is wrong on the start's lattice, or forces that are not equal and opposite, move them.
    /// </summary>
    public sealed class FreeFallCase : ValidationCase
    {
        private const double Edge = 0.3;
        private const double Fall = 1.5;
        private const double Gravity = 9.81;
        private const double Margin = 0.25; // beside, above and below the block's path [m]
        private const int Samples = 8;

        /// <inheritdoc/>
        public override string Name => "free-fall";

        /// <inheritdoc/>
        public override string Title => "Free fall";

        /// <inheritdoc/>
        public override string Source => "exact: nothing moves relative to anything";

        /// <inheritdoc/>
        public override string ErrorName => RelativeMotionMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 1.0;

        /// <summary>An exact lattice: jitter would move by its own pressure.</summary>
        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 7, 5.0, jitter: 0.0);

        /// <summary>A block <see cref="CaseParameters.Resolution"/> particles in edge; speeds are over the last one of the fall.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 3);
            double dx = Edge / parameters.Resolution;
            double speed = Math.Sqrt(2.0 * Gravity * Fall);
            var domain = new Vector3((float)(Edge + 2.0 * Margin), (float)(Edge + Fall + 2.0 * Margin), (float)(Edge + 2.0 * Margin));
            Vector3 corner = new Vector3((float)(-0.5 * Edge), 0.5f * domain.y - (float)(Margin + Edge), (float)(-0.5 * Edge));
            List<Vector3> block = CaseLattice.Box(Vector3Int.one * parameters.Resolution, dx, corner);
            CaseLattice.Jitter(block, parameters.Jitter * dx, parameters.Seed, 0.5f * domain);
            double duration = Math.Sqrt(2.0 * Fall / Gravity);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f)),
                Particles = CaseLattice.Particles(block),
                Duration = duration,
                SampleInterval = duration / Samples,
                IsOpen = true,
                SpeedLimit = 3.0 * speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new RelativeMotionMetric(setup.Settings.Spacing);
    }
}
