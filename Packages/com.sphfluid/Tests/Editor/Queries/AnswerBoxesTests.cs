using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AnswerBoxes against sums over all particles, and against volumes that are known.</summary>
    public sealed class AnswerBoxesTests
    {
        private const float Spacing = 0.02f;

        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private struct Box
        {
            public Vector3 Centre, Size;
            public Quaternion Rotation;
        }

        private static FluidBoxResult[] Ask(in FluidSolverSettings settings, FluidParticle[] particles, Box[] boxes, int times = 1,
            uint start = 0u)
        {
            var words = new QueryWord[AnswerBoxesPass.Words * boxes.Length];
            for (int i = 0; i < boxes.Length; i++)
            {
                Quaternion turn = QueryRig.Turn * boxes[i].Rotation;
                words[4 * i] = new QueryWord { Vector = QueryRig.World(boxes[i].Centre), Number = (uint)(i + 1) };
                words[4 * i + 1] = new QueryWord(turn * Vector3.right, 0.5f * boxes[i].Size.x);
                words[4 * i + 2] = new QueryWord(turn * Vector3.up, 0.5f * boxes[i].Size.y);
                words[4 * i + 3] = new QueryWord(turn * Vector3.forward, 0.5f * boxes[i].Size.z);
            }
            using (var rig = new QueryRig(settings, particles))
            using (GraphicsBuffer sums = GpuBuffers.Create("Sums", Math.Max(1, AnswerBoxesPass.Sums * boxes.Length), sizeof(uint)))
            {
                var zeros = new uint[sums.count];
                zeros[0] = start;
                sums.SetData(zeros);
                var pass = new AnswerBoxesPass(rig.Shaders);
                FluidBoxResult[] found = null;
                for (int i = 0; i < times; i++)
                {
                    found = rig.Ask<FluidBoxResult>(words, boxes.Length, 5,
                        (cmd, target, queries) => pass.Record(cmd, target, queries, sums, boxes.Length, 5));
                }
                return found;
            }
        }

        [TestCase(0, 1009)]
        [TestCase(1, 1)]
        [TestCase(1, 255)]
        [TestCase(15, 256)]
        [TestCase(16, 257)]
        [TestCase(17, 1009)]
        [TestCase(35, 1009, FluidAxes.X | FluidAxes.Z)]
        public void VolumesAgreeWithSumsOverAllParticles(int count, int particleCount, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] particles = ParticleSets.Random(particleCount, Domain, 1f, 3);
            var random = new System.Random(4);
            Box[] boxes = Enumerable.Range(0, count).Select(_ => new Box
            {
                Centre = Vector3.Scale(ParticleSets.RandomVector(random), Domain),
                Size = new Vector3(0.01f, 0.03f, 0.05f) +
                    0.3f * new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble()),
                Rotation = Quaternion.Euler(400f * ParticleSets.RandomVector(random)),
            }).ToArray();
            FluidBoxResult[] found = Ask(settings, particles, boxes, 2); // the sums are zero again after the first
            double volume = Math.Pow(settings.Spacing, 3.0);
            for (int i = 0; i < count; i++)
            {
                (double parts, int inside, int touched) = Expected(boxes[i], particles, settings);
                Assert.That(found[i].Generation, Is.EqualTo(i + 1));
                Assert.That(found[i].Volume / volume, Is.EqualTo(parts).Within(1e-4 + touched * 0.6 / 256.0), $"box {i}");
                Assert.That(found[i].Particles, Is.EqualTo(inside).Within(1), $"box {i}"); // one may lie on a face
                double fill = settings.ParticleMass / (settings.RestDensity * volume) * found[i].Volume /
                    (boxes[i].Size.x * boxes[i].Size.y * boxes[i].Size.z);
                Assert.That(found[i].Fill, Is.EqualTo(Math.Min(1.0, fill)).Within(1e-5));
            }
            if (count > 10) Assert.That(found.Max(f => f.Particles), Is.GreaterThan(5));
        }

        private static (double parts, int inside, int touched) Expected(in Box box, FluidParticle[] particles,
            in FluidSolverSettings settings)
        {
            double side = settings.Spacing, sum = 0.0;
            int inside = 0, touched = 0;
            Vector3 period = settings.PeriodLength;
            foreach (FluidParticle particle in particles)
            {
                Vector3 apart = particle.Position - box.Centre;
                for (int axis = 0; axis < 3; axis++)
                    if (period[axis] > 0f) apart[axis] -= period[axis] * Mathf.Round(apart[axis] / period[axis]);
                Vector3 along = Quaternion.Inverse(box.Rotation) * apart;
                double part = 1.0;
                bool isInside = true;
                for (int axis = 0; axis < 3; axis++)
                {
                    double low = Math.Max(along[axis] - 0.5 * side, -0.5 * box.Size[axis]),
                        high = Math.Min(along[axis] + 0.5 * side, 0.5 * box.Size[axis]);
                    part *= Math.Max(0.0, high - low) / side;
                    isInside &= Math.Abs(along[axis]) <= 0.5f * box.Size[axis];
                }
                sum += part;
                inside += isInside ? 1 : 0;
                touched += part > 0.0 ? 1 : 0;
            }
            return (sum, inside, touched);
        }

        // As if 16,777,215 particles had been counted before.
        [Test]
        public void TheSumGoesOnBeyondAWord()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            FluidParticle[] particles = ParticleSets.Random(300, Domain, 1f, 3);
            var all = new Box { Centre = Vector3.zero, Size = 2f * Domain, Rotation = Quaternion.identity };
            FluidBoxResult found = Ask(settings, particles, new[] { all }, 1, 0xffffff00u)[0];
            Assert.That(found.Volume / Math.Pow(settings.Spacing, 3.0), Is.EqualTo(16777215.0 + 300.0).Within(4.0)); // a float's rounding
            Assert.That(found.Particles, Is.EqualTo(300));
        }

        // Water of 24 x 15 x 20 particles at the floor of a tank.
        [TestCase(0f, 0f, 0f)]
        [TestCase(30f, 0f, 0f)]
        [TestCase(20f, 40f, 65f)]
        public void TheVolumeInABoxInAPoolIsThatOfItsGeometry(float x, float y, float z)
        {
            FluidSolverSettings settings = TestSettings.ByRule(new Vector3(24, 30, 20) * Spacing, Spacing);
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(24, 15, 20), Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position.y -= 7.5f * Spacing;
            Box[] boxes = new[] { -0.15f, -0.07f, -0.03f, 0f, 0.04f, 0.3f }.Select(height => new Box
            {
                Centre = new Vector3(0.013f, height, -0.007f), // the surface is at 0
                Size = new Vector3(0.1f, 0.12f, 0.14f),
                Rotation = Quaternion.Euler(x, y, z),
            }).ToArray();
            FluidBoxResult[] found = Ask(settings, particles, boxes);
            for (int i = 0; i < boxes.Length; i++)
            {
                double part = Below(boxes[i]), box = (double)boxes[i].Size.x * boxes[i].Size.y * boxes[i].Size.z;
                Assert.That(found[i].Volume / box, Is.EqualTo(part).Within(0.01), $"centre at {boxes[i].Centre.y}");
            }
        }

        [Test]
        public void OfWaterAtRestTheFillLevelIsThatOfItsSurface()
        {
            const float spacing = 0.03f;
            var counts = new Vector3Int(12, 9, 12);
            Vector3 domain = spacing * new Vector3(12, 18, 12);
            FluidSolverSettings settings = BodyRig.Water(domain, spacing, counts.y * spacing);
            FluidParticle[] particles;
            using (var rig = new FloatingRig(settings, FloatingRig.Block(counts, spacing, -0.5f * domain)))
            {
                for (int frame = 0; frame < 25; frame++) rig.Frame(Mathf.CeilToInt(1f / 60f / settings.TimeStep));
                particles = rig.Particles();
            }
            float level = Level(settings, particles);
            Box[] boxes = new[] { -0.14f, -0.05f, 0f,
                0.03f }.Select(height =>
                    new Box
                    {
                        Centre = new Vector3(0f, level + height, 0f), Size = new Vector3(0.28f, 0.2f, 0.28f),
                        Rotation = Quaternion.identity
                    }).ToArray();
            FluidBoxResult[] found = Ask(settings, particles, boxes);
            TestContext.WriteLine(
                $"level {level:f4} m: fill {string.Join(", ", found.Select(f => f.Fill.ToString("f4")))}, by volume " +
                $"{string.Join(", ", found.Select(f => (f.Volume / 0.01568f).ToString("f4")))}");
            float[] expected = { 1f, 0.75f, 0.5f, 0.35f };
            for (int i = 0; i < boxes.Length; i++) Assert.That(found[i].Fill, Is.EqualTo(expected[i]).Within(0.015f), $"{i}");
        }

        // Where rays down meet the water, in the mean.
        private static float Level(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            const int rays = 121;
            var words = new QueryWord[AnswerRaysPass.Words * rays];
            for (int i = 0; i < rays; i++)
            {
                words[2 * i] =
                    new QueryWord { Vector = QueryRig.World(new Vector3(0.035f * (i % 11 - 5), 0.3f, 0.035f * (i / 11 - 5))), Number = 1u };
                words[2 * i + 1] = new QueryWord(QueryRig.Turn * Vector3.down, 1f);
            }
            using (var rig = new QueryRig(settings, particles))
            {
                var pass = new AnswerRaysPass(rig.Shaders);
                return 0.3f - rig.Ask<FluidRayResult>(words, rays, 0, (cmd, target, queries) => pass.Record(cmd, target, queries, rays, 0))
                    .Average(r => r.Distance);
            }
        }

        // Part of a box below the plane y = 0 and above the floor.
        private static double Below(in Box box)
        {
            const int n = 60;
            int below = 0;
            for (int i = 0; i < n * n * n; i++)
            {
                var cell = new Vector3((i % n + 0.5f) / n - 0.5f, (i / n % n + 0.5f) / n - 0.5f, (i / n / n + 0.5f) / n - 0.5f);
                float height = (box.Centre + box.Rotation * Vector3.Scale(cell, box.Size)).y;
                below += height < 0f && height > -0.3f ? 1 : 0;
            }
            return below / (double)(n * n * n);
        }
    }
}
