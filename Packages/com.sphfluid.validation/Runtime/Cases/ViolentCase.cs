using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A block of water is thrown at 4 m/s in a closed box: it hits a wall, rises, falls back and comes to rest. With frames of 1/60 s it
    /// goes more than three spacings a frame. Nothing works on it, so its energy may fall but not grow; nobody leaves the box; and in the
    /// end it stands as high as its volume.
    /// </summary>
    public sealed class ViolentCase : ValidationCase
    {
        /// <summary>A frame [s]: the method Robust cuts it into four steps at the base.</summary>
        public const double Frame = 1.0 / 60.0;

        private const double Speed = 4.0;
        private const double Viscosity = 0.002;
        private const double Gravity = 9.81;
        private const double Width = 0.32; // of the block
        private const double Height = 0.4, Length = 0.8, Depth = 0.2, Ceiling = 1.2;
        private const double Duration = 3.0;
        private const int Substeps = 4;
        private const double BaseFraction = 0.75;

        /// <inheritdoc/>
        public override string Name => "violent";

        /// <inheritdoc/>
        public override string LengthTitle => "width of the block";

        /// <inheritdoc/>
        public override string Title => "A block thrown in a box";

        /// <inheritdoc/>
        public override string Source => "exact: the energy does not grow, nobody leaves, and the volume stays";

        /// <inheritdoc/>
        public override string ErrorName => ViolentMetric.ErrorName;

        /// <inheritdoc/>
        public override bool IsGate => true;

        /// <inheritdoc/>
        public override double Limit => 0.02;

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 5.0, 0.03);

        /// <summary>
        /// A block <see cref="CaseParameters.Resolution"/> particles wide; speeds are over that of the block at the foot of its fall, 4.9
        /// m/s.
        /// </summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 6);
            double dx = Width / parameters.Resolution;
            int Count(double length) => (int)Math.Round(length / dx);
            var domain = new Vector3((float)(Count(Length) * dx), (float)(Count(Ceiling) * dx), (float)(Count(Depth) * dx));
            List<Vector3> block = CaseLattice.Box(new Vector3Int(parameters.Resolution, Count(Height), Count(Depth)), dx, -0.5f * domain);
            CaseLattice.Jitter(block, parameters.Jitter * dx, parameters.Seed, 0.4999f * domain);
            double speed = Math.Sqrt(Speed * Speed + 2.0 * Gravity * Height);
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, dx, speed, new Vector3(0f, -(float)Gravity, 0f), Viscosity);
            if (settings.Method == FluidMethodKind.Robust)
            {
                settings.TimeStep = (float)(Frame / Substeps * parameters.TimeStepFraction / BaseFraction);
                float depth = (float)(Width * Height / Length);
                settings = settings.WithOwn((ref RobustSettings own) => own.DepthSpeed = Mathf.Sqrt((float)Gravity * depth));
            }
            return new CaseSetup
            {
                Settings = settings,
                Particles = CaseLattice.Particles(block, p => new Vector3((float)Speed, 0f, 0f)),
                Duration = Duration,
                SampleInterval = Frame,
                SpeedLimit = 20.0 * speed,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) =>
            new ViolentMetric(setup.Settings,
                setup.Particles.Length * Math.Pow(setup.Settings.Spacing, 3.0) /
                    (setup.Settings.DomainSize.x * (double)setup.Settings.DomainSize.z));
    }
}
