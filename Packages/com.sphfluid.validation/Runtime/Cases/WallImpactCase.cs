using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Water of 1.2 × 0.6 m runs along a dry floor, hits the wall at the other end, 3.22 m from the closed one, and runs up it: the dam
    /// break of Buchner 2002 and, half as large, of Lobovský and others 2014. What the wall feels at four gauges until the water comes
    /// back, against a converged solution. A thin slab, periodic across.
    /// </summary>
    public sealed class WallImpactCase : ValidationCase
    {
        private const double Gravity = 9.81;
        private const double TankHeight = 3.0; // over the water's
        private const double LastTime = 6.05; // in √(H/g)
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
        public override string Source =>
            "converged solution: De Courcy et al. 2024, Comput. Methods Appl. Mech. Eng. 420, 116700; measured: Lobovský et al. 2014, " +
            "J. Fluids Struct. 48, 407; Buchner 2002, TU Delft";

        /// <inheritdoc/>
        public override string ErrorName => WallImpactMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("impulse on the gauges over the converged one − 1", 0.0), ("water comes late, over √(H/g)", 0.0) };

        /// <inheritdoc/>
        public override double Floor => WallImpactMetric.BetweenSolvers;

        /// <inheritdoc/>
        public override string FloorSource =>
            "two converged solvers, De Courcy et al. 2024 and TrixiParticles.jl, lie so far apart";

        /// <inheritdoc/>
        public override string Caution =>
            "The solution is of two dimensions, without air and friction: experiments, the grey band, have less at the lower gauges and " +
            "up to twice as much at the highest. A gauge is a spacing high where that is more than its 8.4 mm.";

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
            const double height = ConvergedPressure.WaterHeight;
            double dx = height / parameters.Resolution;
            int rows = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)ConvergedPressure.TankLength, (float)(TankHeight * height), (float)(rows * dx));
            double speed = Math.Sqrt(2.0 * Gravity * height), unit = Math.Sqrt(height / Gravity);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f), null,
                    new FluidBoundaries { Periodic = FluidAxes.Z }),
                Particles = Water(parameters, domain, rows, dx, speed),
                Patches = Gauges(domain, dx),
                Duration = LastTime * unit,
                SampleInterval = Interval * unit,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup)
        {
            // What stands and moves is particles, and their mass in their place is the liquid's density.
            double density = setup.Settings.ParticleMass / Math.Pow(setup.Settings.Spacing, 3.0);
            const double height = ConvergedPressure.WaterHeight;
            return new WallImpactMetric(Math.Sqrt(height / Gravity), density * Gravity * height);
        }

        // As wide as the slab. None is less than a spacing high, or it would stand between two layers of particles.
        private static CasePatch[] Gauges(Vector3 domain, double dx)
        {
            double side = Math.Max(ConvergedPressure.GaugeSize, dx);
            return ConvergedPressure.Gauges.Select(height => new CasePatch(
                new Vector3(0.5f * domain.x, (float)Math.Max(height * ConvergedPressure.WaterHeight, 0.5 * side) - 0.5f * domain.y, 0f),
                Vector3.left, Vector3.up, new Vector2(domain.z, (float)side))).ToArray();
        }

        // Compressed by its own weight, as it stands behind the gate.
        private static FluidParticle[] Water(in CaseParameters parameters, Vector3 domain, int rows, double dx, double speed)
        {
            const double height = ConvergedPressure.WaterHeight;
            double sound = parameters.SoundSpeedRatio * speed, m = sound * sound / (Gravity * height);
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(2 * parameters.Resolution, parameters.Resolution, rows), dx,
                new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            WallCaseSetup.Settle(positions, height, m, domain);
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
