using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A column of water collapses in a closed box, sloshes and comes to rest. Nothing works on it, so the energy may fall but not grow.
    /// </summary>
    public sealed class EnergyCase : ValidationCase
    {
        private const double Height = 1.0; // of the column [m]
        private const double Width = 0.5;
        private const double Length = 1.0; // of the box
        private const double Gravity = 9.81;
        private const double Duration = 8.0; // in √(H/g)
        private const double SamplesPerTime = 10.0;

        /// <inheritdoc/>
        public override string Name => "energy";

        /// <inheritdoc/>
        public override string Title => "Energy of a collapse";

        /// <inheritdoc/>
        public override string Source => "exact: the energy does not grow";

        /// <inheritdoc/>
        public override string ErrorName => EnergyMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 0.05;

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 5.0);

        /// <summary>A column <see cref="CaseParameters.Resolution"/> particles high; speeds are over √(2 g H).</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 6);
            double dx = Height / parameters.Resolution;
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)Length, (float)(1.5 * Height), (float)(width * dx));
            var counts = new Vector3Int((int)Math.Round(Width / dx), parameters.Resolution, width);
            List<Vector3> column = CaseLattice.Box(counts, dx, -0.5f * domain);
            CaseLattice.Jitter(column, parameters.Jitter * dx, parameters.Seed, 0.4999f * domain);
            double speed = Math.Sqrt(2.0 * Gravity * Height);
            double time = Math.Sqrt(Height / Gravity);
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f), null,
                    new FluidBoundaries { Periodic = FluidAxes.Z }),
                Particles = CaseLattice.Particles(column),
                Duration = Duration * time,
                SampleInterval = time / SamplesPerTime,
                SpeedLimit = 3.0 * speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup)
        {
            double mass = setup.Particles.Length * (double)setup.Settings.ParticleMass;
            double level = 0.5 * Height * Width / Length - 0.5 * setup.Settings.DomainSize.y;
            return new EnergyMetric(setup.Settings, mass * Gravity * level);
        }
    }
}
