using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A box, 0.8 m wide with a draught of 0.4 m, floats across a tank 4 m long and 1 m deep. It is held 0.08 m above where it would rest
    /// and released: it heaves, makes waves and meets them again. The box is a mesh that the liquid moves, and weighs as much as what it
    /// displaces at rest. A thin slab, periodic across.
    /// </summary>
    public sealed class HeaveCase : ValidationCase
    {
        private const double Depth = 1.0, Gravity = 9.81;
        private const double Freeboard = 0.3;
        private const double Lasts = 2.5;
        private const double Samples = 60.0; // a second
        private const int GridCells = 60; // of the reference, over the depth

        /// <inheritdoc/>
        public override string Name => "heave";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "floating", "buoyancy" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth";

        /// <inheritdoc/>
        public override string Title => "A floating box heaves";

        /// <inheritdoc/>
        public override string Source => "linear potential flow in the same tank, computed here by finite volumes";

        /// <inheritdoc/>
        public override string ErrorName => HeaveMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld => new[]
        {
            ("floats too high, over the draught", 0.0),
            ("first trough, time over the exact one − 1", 0.0),
            ("first trough, depth over the exact one − 1", 0.0),
        };

        /// <summary>What the linear reference leaves out is of the order of (height at the start over draught)².</summary>
        /// <inheritdoc/>
        public override double Floor => 0.04;

        /// <inheritdoc/>
        public override string FloorSource =>
            "the reference's own, as linear flow leaves out (height at the start over draught)²";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t [s]", "height above rest over that at the start");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 20, 6.0);

        /// <summary>
        /// <see cref="CaseParameters.Resolution"/> particles over the depth; box, lift and tank are whole spacings, and the reference is
        /// computed for those. Speeds are over √(gH).
        /// </summary>
        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 8);
            var cells = new Sizes(parameters);
            int width = WallCaseSetup.PeriodicCount(parameters);
            var domain = new Vector3((float)(2 * cells.HalfLength * cells.Spacing), (float)(Depth + Freeboard),
                (float)(width * cells.Spacing));
            FluidSolverSettings settings = CaseSettings.For(parameters, domain, cells.Spacing, Math.Sqrt(Gravity * Depth),
                new Vector3(0f, -(float)Gravity, 0f), null, new FluidBoundaries { Periodic = FluidAxes.Z });
            Sizes sizes = cells.Compressed(WallCaseSetup.Stiffness(parameters, settings));
            CaseBody box = Box(sizes, settings);
            RequireFloating(settings, box);
            return new CaseSetup
            {
                Settings = settings,
                Particles = Water(parameters, sizes, domain, width),
                Bodies = new[] { box },
                Duration = Lasts,
                SampleInterval = 1.0 / Samples,
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup)
        {
            Sizes sizes = new Sizes(parameters).Compressed(WallCaseSetup.Stiffness(parameters, setup.Settings));
            double height = sizes.LiftedBottom - sizes.RestingBottom, rest = setup.Bodies[0].Centre.y - height;
            return new HeaveMetric(Reference(sizes).Release(height, Lasts, 1.0 / Samples), 1.0 / Samples, rest,
                sizes.Draught * sizes.Spacing);
        }

        private static HeaveTank Reference(in Sizes sizes)
        {
            int fine = Math.Max(1, GridCells / sizes.Resolution);
            return new HeaveTank(fine * sizes.HalfLength, (int)Math.Round(fine * sizes.RestingRows), fine * sizes.HalfBeam,
                fine * sizes.Draught, sizes.Spacing / fine, Gravity);
        }

        // A method that moves no bodies says so now and not when the run has begun.
        private static void RequireFloating(in FluidSolverSettings settings, CaseBody box)
        {
            using (var obstacles = new FluidObstacles(settings))
                new CaseBodies(new[] { box }).AddTo(obstacles);
        }

        private static CaseBody Box(in Sizes sizes, in FluidSolverSettings settings)
        {
            double beam = 2 * sizes.HalfBeam * sizes.Spacing, draught = sizes.Draught * sizes.Spacing;
            double displaced = 2 * sizes.HalfBeam * sizes.Draught * settings.DomainSize.z / sizes.Spacing; // particles
            float height = (float)draught + (float)Freeboard, beyond = 8f * settings.SupportRadius;
            return new CaseBody
            {
                Mesh = TriangleMesh.Box(Matrix4x4.Scale(new Vector3((float)beam, height, settings.DomainSize.z + beyond))),
                Centre = new Vector3(0f, (float)sizes.LiftedBottom - 0.5f * settings.DomainSize.y + 0.5f * height, 0f),
                Mass = (float)(settings.ParticleMass * displaced),
            };
        }

        private static FluidParticle[] Water(in CaseParameters parameters, Sizes sizes, Vector3 domain, int width)
        {
            double dx = sizes.Spacing;
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(2 * sizes.HalfLength, sizes.Resolution, width), dx,
                new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            positions.RemoveAll(p => Math.Abs(p.x) < sizes.HalfBeam * dx && p.y > sizes.LiftedRows * dx);
            for (int i = 0; i < positions.Count; i++)
            {
                Vector3 p = positions[i];
                positions[i] = new Vector3(p.x, (float)sizes.Settled(p.y, sizes.Resolution) - 0.5f * domain.y, p.z);
            }
            return WallCaseSetup.AtRest(positions, parameters, dx, domain);
        }

        // Box, tank and liquid at the start in whole spacings. Released, the box sinks by less than it is too high: it raises the level as
        // it goes.
        private readonly struct Sizes
        {
            private const int LengthOverBeam = 5;

            private readonly double ratio; // c²/(gH)

            public Sizes(in CaseParameters parameters) : this(parameters.Resolution, double.PositiveInfinity)
            {
            }

            private Sizes(int resolution, double ratio)
            {
                Resolution = resolution;
                Draught = (int)Math.Round(0.4 * Resolution);
                Lift = Math.Max(1, (int)Math.Round(0.1 * Resolution));
                this.ratio = ratio;
            }

            /// <summary>The same in liquid of c² = ratio g H.</summary>
            public Sizes Compressed(double ofRatio) => new Sizes(Resolution, ofRatio);

            public int Resolution { get; }

            public int Draught { get; }

            public int Lift { get; }

            public int HalfBeam => Draught;

            public int HalfLength => LengthOverBeam * HalfBeam;

            public int LiftedRows => Resolution - Draught + Lift;

            /// <summary>Rows of the level at rest: what the box displaces more of then is spread over the tank.</summary>
            public double RestingRows => Resolution + (double)Lift / LengthOverBeam;

            public double Spacing => Depth / Resolution;

            /// <summary>
            /// Height above the floor of the box's bottom when it is released [m]: liquid of so many rows ends there, compressed by what
            /// stands beside it.
            /// </summary>
            public double LiftedBottom => Settled(LiftedRows * Spacing, Resolution);

            /// <summary>The same where it floats at rest [m].</summary>
            public double RestingBottom => Settled((RestingRows - Draught) * Spacing, RestingRows);

            /// <summary>Height at rest of what is at y in a column of so many rows at rest density [m].</summary>
            public double Settled(double y, double rows) => WallCaseSetup.Settled(y, rows * Spacing, ratio * Resolution / rows);
        }
    }
}
