using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Two blocks of liquid collide off centre in a box without walls: all three axes are periodic, and there is no gravity. Nothing can
    /// give or take momentum, so forces that are not equal and opposite show, and so do pairs of which one side is missed.
    /// </summary>
    public sealed class MomentumCase : ValidationCase
    {
        private const double Edge = 1.0; // of the box [m]
        private const double Speed = 1.0; // of the blocks to each other [m/s]
        private const int Steps = 1000;
        private const int Samples = 20;

        /// <inheritdoc/>
        public override string Name => "momentum";

        /// <inheritdoc/>
        public override string Title => "Momentum";

        /// <inheritdoc/>
        public override string Source => "exact: Σ m v does not change";

        /// <inheritdoc/>
        public override string ErrorName => MomentumMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 1e-5;

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 5.0);

        /// <summary>A box <see cref="CaseParameters.Resolution"/> particles in edge, of which the blocks fill a fifth.</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, Math.Max(8, WallCaseSetup.PeriodicCount(parameters)));
            double dx = Edge / parameters.Resolution;
            int n = parameters.Resolution, side = n / 2, depth = 3 * n / 8;
            var counts = new Vector3Int(depth, side, side);
            // They touch at x = 0, and each has half of its face beside the other's.
            List<Vector3> blocks = CaseLattice.Box(counts, dx, (float)dx * new Vector3(-depth, -side, -0.5f * side));
            int first = blocks.Count;
            blocks.AddRange(CaseLattice.Box(counts, dx, (float)dx * new Vector3(0f, -0.5f * side, -0.5f * side)));
            CaseLattice.Jitter(blocks, parameters.Jitter * dx, parameters.Seed, 0.4999f * (float)Edge * Vector3.one);
            FluidParticle[] particles = CaseLattice.Particles(blocks);
            for (int i = 0; i < particles.Length; i++)
            {
                Vector3 velocity = (float)Speed * (i < first ? new Vector3(0.6f, 0.1f, 0f) : new Vector3(-0.4f, 0f, 0.05f));
                particles[i] = new FluidParticle(particles[i].Position, velocity, particles[i].Id);
            }
            FluidSolverSettings settings = CaseSettings.For(parameters, Vector3.one * (float)Edge, dx, Speed, Vector3.zero, null,
                new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Y | FluidAxes.Z });
            double duration = Steps * (double)settings.TimeStep;
            return new CaseSetup
            {
                Settings = settings,
                Particles = particles,
                Duration = duration,
                SampleInterval = duration / Samples,
                SpeedLimit = 3.0 * Speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new MomentumMetric();
    }
}
