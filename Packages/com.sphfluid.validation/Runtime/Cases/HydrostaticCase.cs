using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A column of water at rest, 1 m deep, 8 particles wide. It stands on the floor of the domain and is periodic across, which
    /// leaves the law of pressure over depth alone. Between four walls (<see cref="Walls"/>) it is 12 wide, so that there is liquid three
    /// spacings from each; 44 of a layer's 144 particles lie at a wall, and the column shows the walls: the thesis method has no
    /// particles in them, so that density is missing there and the column sinks.
    /// </summary>
    public sealed class HydrostaticCase : ValidationCase
    {
        private const double Depth = 1.0;
        private const double Gravity = 9.81;
        private const double Settles = 15.0; // of Lasts, times √(H/g)
        private const double Lasts = 20.0;
        private const double SamplesPerTime = 10.0;

        /// <summary>True: four walls instead of periodic sides.</summary>
        public bool Walls { get; set; }

        /// <inheritdoc/>
        public override string Name => "hydrostatic";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "pool", "rest" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth of the water";

        /// <inheritdoc/>
        public override string Title => "Column at rest";

        /// <inheritdoc/>
        public override string Source => "p = ρ0 c² (e^(g d/c²) − 1) ≈ ρ g d; height m ln(1 + 1/m) H of p = c² (ρ − ρ0), c² = m g H";

        /// <inheritdoc/>
        public override string ErrorName => HydrostaticMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("height lost beyond the equation of state's", 0.0), ("v_rms/√(gH)", 0.0) };

        /// <inheritdoc/>
        public override string Caution =>
            "Compared is the pressure that pushes. Standard reads it; the thesis method reads twice as much, " +
            "because the ½ of its equation (13) halves the force.";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("depth/H", "p/(ρ g H)");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 20, 6.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 10);
            double dx = Depth / parameters.Resolution;
            int width = Width(parameters);
            double time = Math.Sqrt(Depth / Gravity);
            var domain = new Vector3((float)(width * dx), (float)(Depth + 4.0 * dx), (float)(width * dx));
            var boundaries = new FluidBoundaries { Periodic = Walls ? FluidAxes.None : FluidAxes.X | FluidAxes.Z };
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, Math.Sqrt(Gravity * Depth),
                new Vector3(0f, -(float)Gravity, 0f), null, boundaries);
            return new CaseSetup
            {
                Settings = settings,
                Particles = Column(parameters, settings, width, dx),
                Duration = Lasts * time,
                SampleInterval = time / SamplesPerTime,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup)
        {
            int width = Width(parameters);
            return new HydrostaticMetric(setup.Settings, Depth, width * width, Settles * Math.Sqrt(Depth / Gravity));
        }

        private int Width(in CaseParameters parameters) => Walls ? 12 : Math.Max(8, WallCaseSetup.PeriodicCount(parameters));

        // Compressed as the equation of state has it at rest, so that there is little to settle.
        private static FluidParticle[] Column(in CaseParameters parameters, in FluidSolverSettings settings, int width, double dx)
        {
            Vector3 domain = settings.DomainSize;
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(width, parameters.Resolution, width), dx,
                new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            WallCaseSetup.Settle(positions, Depth, WallCaseSetup.Stiffness(parameters, settings), domain);
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
