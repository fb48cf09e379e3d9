using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Start-up of a flow along x between two plane walls one metre apart, ν = 0.01 m²/s, periodic along x and z, without
    /// gravity across. It takes the solver's walls without slip: the thesis's own walls only push, so that a Couette flow
    /// never starts (wrong by 100 %) and a Poiseuille flow falls freely. Fastest speed 0.1 m/s, Re = 10: laminar, and
    /// particles travel far past each other, which they would not at the Re = 0.0125 of the customary set-up.
    /// </summary>
    public abstract class ChannelCase : ValidationCase
    {
        /// <summary>Distance of the walls L [m].</summary>
        protected const double Gap = 1.0;

        /// <summary>Kinematic viscosity ν [m²/s].</summary>
        protected const double Viscosity = 0.01;

        /// <summary>Fastest speed of the steady flow [m/s].</summary>
        protected const double MaxSpeed = 0.1;

        private const double Interval = 2.0;
        private static readonly double[] Times = { 2.0, 10.0, 20.0, 100.0 };

        /// <summary>False: the thesis's own walls, which have no friction.</summary>
        public bool NoSlip { get; set; } = true;

        /// <inheritdoc/>
        public override string Source =>
            "series solutions (Morris, Fox and Zhu 1997); the walls without slip are an option of the solver, not the thesis's";

        /// <inheritdoc/>
        public override string ErrorName => ChannelMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld => new[] { ("flow across the channel, RMS/u_max", 0.0) };

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("y/L", "u/u_max");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 10.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 4);
            double dx = Gap / parameters.Resolution;
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)(width * dx), (float)Gap, (float)(width * dx));
            var boundaries = new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z, NoSlip = NoSlip };
            if (NoSlip) boundaries.HighY = new Vector3((float)UpperWall, 0f, 0f);
            FluidSolverSettings settings =
                CaseSettings.For(parameters, domain, dx, MaxSpeed, new Vector3((float)Force, 0f, 0f), Viscosity, boundaries);
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(width, parameters.Resolution, width), dx, -0.5f * domain);
            return new CaseSetup
            {
                Settings = settings,
                Particles = WallCaseSetup.AtRest(positions, parameters, dx, domain),
                Duration = Times[Times.Length - 1],
                SampleInterval = Interval,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new ChannelMetric(Gap, MaxSpeed, Exact, Times, Interval, parameters.Resolution);

        /// <summary>Speed of the upper wall [m/s].</summary>
        protected abstract double UpperWall { get; }

        /// <summary>Force per mass along x [m/s²].</summary>
        protected abstract double Force { get; }

        /// <summary>u [m/s] at a distance from the lower wall [m] and a time [s].</summary>
        protected abstract double Exact(double y, double t);
    }
}
