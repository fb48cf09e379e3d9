using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// MARIN's dam break against a box, SPHERIC test case 2: a tank of 3.22 × 1 × 1 m, water of 1.228 × 1 × 0.55 m at one end, a box
    /// of 0.161 × 0.403 × 0.161 m whose centre is 0.744 m from the other end. x counts from that other end, the domain's low face.
    /// <para>At ten particles over the water's height the box is three spacings wide and the wave that runs to it one or two
    /// spacings thick: the heights are those of a coarse picture of the flow. SPHERIC's own spacing, 18.3 mm, is 30 over the height.</para>
    /// </summary>
    public sealed class MarinCase : ValidationCase
    {
        private const double Gravity = 9.81;
        private const double WaterHeight = 0.55;

        // The record's six seconds and a sample.
        private const double Lasts = 6.05;

        private static readonly Vector3 tank = new Vector3(3.22f, 1f, 1f);
        private static readonly Vector3 water = new Vector3(1.228f, (float)WaterHeight, 1f);
        private static readonly Vector3 box = new Vector3(0.161f, 0.161f, 0.403f);
        private const float BoxCentre = 0.744f;

        /// <inheritdoc/>
        public override string Name => "marin";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "flood", "obstacle" };

        /// <inheritdoc/>
        public override string LengthTitle => "the depth of the water";

        /// <inheritdoc/>
        public override string Title => "Dam break against a box (SPHERIC 2)";

        /// <inheritdoc/>
        public override string Source => "Kleefsman and others (2005), J. Comput. Phys. 206, 363-393; heights at four gauges, 0 to 6 s";

        /// <inheritdoc/>
        public override string ErrorName => MarinMetric.ErrorName;

        /// <inheritdoc/>
        public override IReadOnlyList<(string Name, double Right)> AlsoHeld => new[] { ("returning wave, height − 1", 0.0) };

        /// <inheritdoc/>
        public override string Caution => "An error of 1 is no water at all, 0.40 is water that stands at its final level all the time; " +
            "a grid solver's own test suite accepts 0.35.";

        /// <inheritdoc/>
        public override (string X, string Y) AxisTitles => ("t [s]", "height of the water [m]");

        /// <inheritdoc/>
        public override CaseParameters Base(CaseMethod method) => CaseParameters.At(method, 10, 5.0);

        /// <inheritdoc/>
        public override CaseSetup Build(in CaseParameters parameters)
        {
            WallCaseSetup.Require(parameters, Name, 4);
            Vector3Int counts = Counts(parameters.Resolution);
            double volume = (double)water.x * water.y * water.z;
            double dx = Math.Pow(volume / ((double)counts.x * counts.y * counts.z), 1.0 / 3.0);
            double speed = Math.Sqrt(2.0 * Gravity * WaterHeight);
            FluidSolverSettings settings = CaseSettings.For(parameters, tank, dx, speed, new Vector3(0f, -(float)Gravity, 0f));
            return new CaseSetup
            {
                Settings = settings,
                Particles = Water(parameters, settings, counts, dx),
                Duration = Lasts,
                SampleInterval = MarinHeights.Interval,
                Obstacles = new[] { Box() },
                Patches = Faces(),
            };
        }

        /// <inheritdoc/>
        public override CaseMetric CreateMetric(in CaseParameters parameters, CaseSetup setup) => new MarinMetric(setup.Settings);

        // Whole layers that fill the water's box exactly: 22 × 10 × 18 at ten layers, cells of 55.8 × 55 × 55.6 mm, dx³ their volume.
        private static Vector3Int Counts(int layers)
        {
            double dx = WaterHeight / layers;
            return new Vector3Int((int)Math.Round(water.x / dx), layers, (int)Math.Round(water.z / dx));
        }

        private static FluidParticle[] Water(in CaseParameters parameters, in FluidSolverSettings settings, Vector3Int counts, double dx)
        {
            var random = new System.Random(parameters.Seed);
            var corner = new Vector3(0.5f * tank.x - water.x, -0.5f * tank.y, -0.5f * tank.z);
            var particles = new FluidParticle[counts.x * counts.y * counts.z];
            for (int i = 0; i < particles.Length; i++)
            {
                var part = new Vector3((i % counts.x + 0.5f) / counts.x, (i / (counts.x * counts.z) + 0.5f) / counts.y,
                    (i / counts.x % counts.z + 0.5f) / counts.z);
                particles[i] = WallCaseSetup.Particle(corner + Vector3.Scale(part, water), (uint)i, parameters.Jitter * dx,
                    random, settings);
            }
            return particles;
        }

        // Squares about the rows of gauges, as wide as the row is long: of the face that the water hits, and of the top.
        private static CasePatch[] Faces()
        {
            float x = BoxCentre - 0.5f * tank.x, floor = -0.5f * tank.y;
            var size = new Vector2(box.x, box.y);
            return new[]
            {
                new CasePatch(new Vector3(x + 0.5f * box.x, floor + 0.5f * box.y, 0f), Vector3.right, Vector3.up, size),
                new CasePatch(new Vector3(x, floor + box.y, 0f), Vector3.up, Vector3.right, size),
            };
        }

        // Closed, so that a particle that got in gets out again; it stands on the floor.
        private static Vector3[] Box()
        {
            var centre = new Vector3(BoxCentre - 0.5f * tank.x, 0.5f * (box.y - tank.y), 0f);
            TriangleMesh mesh = TriangleMesh.Box(Matrix4x4.TRS(centre, Quaternion.identity, box));
            var corners = new List<Vector3>();
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                corners.AddRange(new[] { a, b, c });
            }
            return corners.ToArray();
        }
    }
}
