using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A tank of water, 2 m long and 1 m deep, is at rest and then accelerated along its length at a constant 0.05 g. The level tilts,
    /// overshoots and swings about the plane at right angles to what now pulls, of slope a/g. Seen from the tank; a thin slab, periodic
    /// across.
    /// </summary>
    public sealed class AcceleratedTankCase : ValidationCase
    {
        private const double Length = 2.0, Depth = 1.0, Gravity = 9.81;
        private const double Slope = 0.05;
        private const double SamplesPerPeriod = 40.0;

        /// <inheritdoc/>
        public override string Name => "accelerated-tank";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "sloshing", "tank" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth";

        /// <inheritdoc/>
        public override string Title => "Levels along an accelerated tank";

        /// <inheritdoc/>
        public override string Source => "exact modes of linear waves in a tank (Lamb, Hydrodynamics, § 257)";

        /// <inheritdoc/>
        public override string ErrorName => AcceleratedTankMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("first mode's period, T/T_exact − 1", 0.0), ("first mode's damping rate over its frequency", 0.0) };

        /// <summary>Terms of third order: (k a)² of the first mode at its highest, 0.081 m.</summary>
        /// <inheritdoc/>
        public override double Floor => 0.02;

        /// <inheritdoc/>
        public override string FloorSource => "the reference's own, as linear waves leave out the third order, (k a)²";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t [s]", "level at the end walls over (a/g) L/2");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 20, 6.0);

        /// <summary><see cref="CaseParameters.Resolution"/> particles over the depth; speeds are over √(gH).</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 6);
            double dx = Depth / parameters.Resolution;
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)Length, (float)(Depth + 2.0 * Slope * Length + 4.0 * dx), (float)(width * dx));
            double period = 2.0 * Math.PI / new TankModes(Length, Depth, Gravity, double.PositiveInfinity).Frequency(1);
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, Math.Sqrt(Gravity * Depth),
                new Vector3((float)(Slope * Gravity), -(float)Gravity, 0f), null, new FluidBoundaries { Periodic = FluidAxes.Z });
            return new CaseSetup
            {
                Settings = settings,
                Particles = Level(parameters, settings, width, dx),
                Duration = (AcceleratedTankMetric.JudgedPeriods + 1.0) * period,
                SampleInterval = period / SamplesPerPeriod,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new AcceleratedTankMetric(
            new TankModes(Length, Depth, Gravity, CaseSettings.EffectiveSoundSpeed(setup.Settings)),
            -0.5 * setup.Settings.DomainSize.x, -0.5 * setup.Settings.DomainSize.y, Slope);

        // At rest under gravity alone, compressed by it.
        private static FluidParticle[] Level(in CaseParameters parameters, in FluidSolverSettings settings, int width, double dx)
        {
            Vector3 domain = settings.DomainSize;
            var counts = new Vector3Int((int)Math.Round(Length / dx), parameters.Resolution, width);
            List<Vector3> positions = CaseLattice.Box(counts, dx, new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            WallCaseSetup.Settle(positions, Depth, WallCaseSetup.Stiffness(parameters, settings), domain);
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
