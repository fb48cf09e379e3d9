using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Buchner's dam break of 2002: water of 1.2 × 0.6 m runs along a dry floor, hits the wall at the other end, 3.22 m from the closed
    /// one, and runs up it. What the wall feels at a gauge near the floor, until the water comes back. A thin slab, periodic across.
    /// </summary>
    public sealed class WallImpactCase : ValidationCase
    {
        private const double Gravity = 9.81;
        private const double TankHeight = 3.0; // over the water's
        private const double LastTime = 5.4; // in √(H/g)
        private const double Interval = 0.05;

        /// <inheritdoc/>
        public override string Name => "wall-impact";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "pressure", "wall" };

        /// <inheritdoc/>
        public override string LengthTitle => "the water's height";

        /// <inheritdoc/>
        public override string Title => "Pressure on a wall that a dam break hits";

        /// <inheritdoc/>
        public override string Source => "measured: Buchner (2002), Green Water on Ship-type Offshore Structures, TU Delft";

        /// <inheritdoc/>
        public override string ErrorName => WallImpactMetric.ErrorName;

        /// <inheritdoc/>
        public override double Floor => 0.1;

        /// <inheritdoc/>
        public override string Caution =>
            "One experiment, without its scatter; its gate holds the water back, so one shift in time is taken out. " +
            "The gauge is 90 mm wide, three spacings of the base.";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t √(g/H)", "pressure at the gauge over ρ g H");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 20, 5.0);

        /// <summary><see cref="CaseParameters.Resolution"/> particles over the water's height; speeds are over √(2gH).</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 8);
            if (!parameters.Method.FeelsWalls)
            {
                throw new ArgumentException($"{Name}: the method {parameters.Method.Name} does not sum the force on walls.");
            }
            const double height = BuchnerPressure.WaterHeight;
            double dx = height / parameters.Resolution;
            int rows = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)BuchnerPressure.TankLength, (float)(TankHeight * height), (float)(rows * dx));
            double speed = Math.Sqrt(2.0 * Gravity * height), unit = Math.Sqrt(height / Gravity);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f), null,
                    new FluidBoundaries { Periodic = FluidAxes.Z }),
                Particles = Water(parameters, domain, rows, dx, speed),
                Patches = new[] { Gauge(domain) },
                Duration = LastTime * unit,
                SampleInterval = Interval * unit,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup)
        {
            // What stands and moves is particles, and their mass in their place is the liquid's density.
            double density = setup.Settings.ParticleMass / Math.Pow(setup.Settings.Spacing, 3.0);
            return new WallImpactMetric(Math.Sqrt(BuchnerPressure.WaterHeight / Gravity), density * Gravity * BuchnerPressure.WaterHeight);
        }

        // As wide as the slab, and as high as the square of the round gauge's area.
        private static CasePatch Gauge(Vector3 domain)
        {
            double side = BuchnerPressure.GaugeDiameter * Math.Sqrt(0.25 * Math.PI);
            return new CasePatch(new Vector3(0.5f * domain.x, (float)BuchnerPressure.GaugeHeight - 0.5f * domain.y, 0f),
                Vector3.left, Vector3.up,
                new Vector2(domain.z, (float)side));
        }

        // Compressed by its own weight, as it stands behind the gate.
        private static FluidParticle[] Water(in CaseParameters parameters, Vector3 domain, int rows, double dx, double speed)
        {
            double sound = parameters.SoundSpeedRatio * speed, height = BuchnerPressure.WaterHeight, m = sound * sound / (Gravity * height);
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(2 * parameters.Resolution, parameters.Resolution, rows), dx,
                new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            WallCaseSetup.Settle(positions, height, m, domain);
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
