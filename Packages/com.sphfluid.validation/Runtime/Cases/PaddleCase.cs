using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A paddle, a plate from below the floor to above the surface, moves to and fro as ½S (1 − cos ωt) at one end of a flume 4 m long and
    /// 1 m deep, kH = 1.5, and makes waves. The plate is a mesh. A thin slab, periodic across; the far end is a wall and reflects, in the
    /// reference too.
    /// </summary>
    public sealed class PaddleCase : ValidationCase
    {
        private const double Length = 4.0, Depth = 1.0, Gravity = 9.81;
        private const double Stroke = 0.08;
        private const double WaveNumber = 1.5; // of the waves that run [1/m]
        private const double Periods = 2.5;
        private const double SamplesPerPeriod = 60.0; // between two of them the paddle moves evenly
        private const int RoomBehind = 4; // in dx

        /// <inheritdoc/>
        public override string Name => "paddle";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "wavemaker" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth";

        /// <inheritdoc/>
        public override string Title => "Waves of a paddle";

        /// <inheritdoc/>
        public override string Source => "exact modes of linear waves; T. H. Havelock 1929, Phil. Mag. 8, 569: H/S of a piston";

        /// <inheritdoc/>
        public override string ErrorName => PaddleMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld =>
            new[] { ("height of the waves over the linear ones' − 1", 0.0), ("waves late, in periods", 0.0) };

        /// <summary>Stokes's second harmonic over the first, (ka/4) cosh kH (2 + cosh 2kH)/sinh³ kH at a = 0.056 m.</summary>
        /// <inheritdoc/>
        public override double Floor => 0.06;

        /// <inheritdoc/>
        public override string FloorSource =>
            "the reference's own, as linear waves leave out Stokes's second harmonic";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t/T", "level above the mean over the stroke");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 16, 6.0);

        /// <summary><see cref="CaseParameters.Resolution"/> particles over the depth; speeds are over √(gH).</summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 6);
            double dx = Depth / parameters.Resolution;
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)(Length + RoomBehind * dx), (float)(Depth + 4.0 * Stroke + 4.0 * dx), (float)(width * dx));
            FluidSolverSettings settings =
                CaseSettings.For(parameters, domain, dx, Math.Sqrt(Gravity * Depth), new Vector3(0f, -(float)Gravity, 0f),
                null, new FluidBoundaries { Periodic = FluidAxes.Z });
            return new CaseSetup
            {
                Settings = settings,
                Particles = Water(parameters, settings, width, dx),
                Bodies = new[] { Plate(domain, dx) },
                Duration = Periods * Period,
                SampleInterval = Period / SamplesPerPeriod,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new PaddleMetric(
            new TankModes(Length, Depth, Gravity, CaseSettings.EffectiveSoundSpeed(setup.Settings)),
            0.5 * setup.Settings.DomainSize.x - Length, Stroke, WaveNumber);

        /// <summary>ω of the waves [1/s].</summary>
        internal static double Frequency => Math.Sqrt(Gravity * WaveNumber * Math.Tanh(WaveNumber * Depth));

        private static double Period => 2.0 * Math.PI / Frequency;

        // Its face is the flume's end; it goes on beyond the domain to all other sides.
        private static CaseBody Plate(Vector3 domain, double dx)
        {
            float room = (float)(4.0 * RoomBehind * dx), thick = room + (float)(RoomBehind * dx);
            float face = 0.5f * domain.x - (float)Length;
            return new CaseBody
            {
                Mesh = TriangleMesh.Box(Matrix4x4.Scale(new Vector3(thick, domain.y + 2f * room, domain.z + 2f * room))),
                Centre = new Vector3(face - 0.5f * thick, 0f, 0f),
                Path = time => new Vector3((float)(0.5 * Stroke * (1.0 - Math.Cos(Frequency * time))), 0f, 0f),
            };
        }

        private static FluidParticle[] Water(in CaseParameters parameters, in FluidSolverSettings settings, int width, double dx)
        {
            Vector3 domain = settings.DomainSize;
            int along = (int)Math.Round(Length / dx);
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(along, parameters.Resolution, width), dx,
                new Vector3((float)(0.5 * domain.x - Length), 0f, -0.5f * domain.z));
            WallCaseSetup.Settle(positions, Depth, WallCaseSetup.Stiffness(parameters, settings), domain);
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }
    }
}
