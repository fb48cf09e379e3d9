using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AnswerPatches against crossings counted on the CPU from where particles are at each look.</summary>
    public sealed class AnswerPatchesTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private sealed class Patch
        {
            public Vector3 Centre, Step;
            public Vector2 Size;
            public Quaternion Rotation, Turn;

            public Vector3 At(int look) => Centre + look * Step;
            public Quaternion RotationAt(int look) => look % 2 == 0 ? Rotation : Rotation * Turn;
        }

        private static Patch[] Patches(int count)
        {
            var random = new System.Random(8);
            float Any() => (float)random.NextDouble();
            return Enumerable.Range(0, count).Select(i => new Patch
            {
                Centre = 0.8f * Vector3.Scale(ParticleSets.RandomVector(random), Domain),
                Step = i % 3 == 0 ? Vector3.zero : 0.03f * ParticleSets.RandomVector(random),
                Size = new Vector2(0.05f + 0.4f * Any(), 0.05f + 0.4f * Any()),
                Rotation = Quaternion.Euler(400f * ParticleSets.RandomVector(random)),
                Turn = i % 3 == 1 ? Quaternion.Euler(20f * ParticleSets.RandomVector(random)) : Quaternion.identity,
            }).ToArray();
        }

        private static QueryWord[] Words(Patch[] patches, int look, uint generation) => patches.SelectMany(p => new[]
        {
            new QueryWord { Vector = QueryRig.World(p.At(look)), Number = generation },
            new QueryWord(QueryRig.Turn * p.RotationAt(look) * Vector3.right, 0.5f * p.Size.x),
            new QueryWord(QueryRig.Turn * p.RotationAt(look) * Vector3.up, 0.5f * p.Size.y),
        }).ToArray();

        private static FluidParticle[] Flying(int count)
        {
            var random = new System.Random(5);
            FluidParticle[] particles = ParticleSets.Random(count, 0.9f * Domain, 1f, 3);
            for (int i = 0; i < count; i++)
            {
                particles[i].VelT0 = particles[i].VelT1 = 4f * ParticleSets.RandomVector(random);
                particles[i].Id = (uint)(1000003 * i + 17); // ids need not be near each other
            }
            return particles;
        }

        [TestCase(0, 257)]
        [TestCase(1, 1)]
        [TestCase(3, 255)]
        [TestCase(17, 256)]
        [TestCase(131, 257)]
        [TestCase(31, 1009)]
        [TestCase(31, 1009, FluidAxes.X | FluidAxes.Z)]
        public void CrossingsAreThoseBetweenLooks(int count, int particleCount, FluidAxes periodic = FluidAxes.None)
        {
            const int looks = 6;
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            settings.Boundaries.Periodic = periodic;
            Patch[] patches = Patches(count);
            var forward = new int[count];
            var backward = new int[count];
            var unsure = new int[count];
            FluidPatchResult[] found = null;
            using (var rig = new QueryRig(settings, Flying(particleCount)))
            using (var sums = new PatchSums())
            using (var retired = new RetiredBuffers())
            {
                var pass = new AnswerPatchesPass(rig.Shaders);
                Dictionary<uint, Vector3> before = null;
                for (int look = 0; look < looks; look++)
                {
                    GpuTest.Run(cmd => rig.Solver.RecordSteps(cmd, 4));
                    found = rig.Ask<FluidPatchResult>(Words(patches, look, 5u), count, 2, (cmd, target, queries) =>
                    {
                        sums.Reserve(count, particleCount, retired);
                        pass.Record(cmd, target, queries, sums, count, 2);
                    });
                    Dictionary<uint, Vector3> now = GpuTest.Read<FluidParticle>(rig.Solver.Particles, particleCount)
                        .ToDictionary(p => p.Id, p => p.Position);
                    for (int i = 0; before != null && i < count; i++)
                        foreach (KeyValuePair<uint, Vector3> particle in now)
                        {
                            Count(patches[i], look, before[particle.Key], particle.Value, settings.PeriodLength, ref forward[i],
                                ref backward[i], ref unsure[i]);
                        }
                    before = now;
                }
            }
            for (int i = 0; i < count; i++)
            {
                Assert.That(found[i].Generation, Is.EqualTo(5u));
                Assert.That((int)found[i].Forwards, Is.EqualTo(forward[i]).Within(unsure[i]), $"patch {i}");
                Assert.That((int)found[i].Backwards, Is.EqualTo(backward[i]).Within(unsure[i]), $"patch {i}");
                Assert.That(found[i].Forward, Is.EqualTo(found[i].Forwards * Math.Pow(settings.Spacing, 3.0)).Within(1).Percent);
                Assert.That(found[i].Volume, Is.EqualTo(found[i].Forward - found[i].Backward).Within(1e-6));
            }
            if (particleCount > 1000 && count > 0) Assert.That(forward.Sum() + backward.Sum(), Is.GreaterThan(200));
            Assert.That(unsure.Sum(), Is.LessThanOrEqualTo(2 + (forward.Sum() + backward.Sum()) / 50));
        }

        private static void Count(Patch patch, int look, Vector3 from, Vector3 to, Vector3 period, ref int forward, ref int backward,
            ref int unsure)
        {
            Vector3 Nearest(Vector3 d)
            {
                for (int axis = 0; axis < 3; axis++)
                    if (period[axis] > 0f) d[axis] -= period[axis] * Mathf.Round(d[axis] / period[axis]);
                return d;
            }
            Vector3 start = Nearest(from - patch.At(look - 1)),
                end = start + Nearest(to - from) - Nearest(patch.At(look) - patch.At(look - 1));
            Vector3 a = Quaternion.Inverse(patch.RotationAt(look - 1)) * start, b = Quaternion.Inverse(patch.RotationAt(look)) * end;
            const float tiny = 1e-5f;
            bool near = Math.Abs(a.z) < tiny || Math.Abs(b.z) < tiny;
            bool crosses = a.z < 0f != b.z < 0f;
            Vector2 at = crosses ? (Vector2)a + a.z / (a.z - b.z) * ((Vector2)b - (Vector2)a) : (Vector2)a;
            float beyond = Mathf.Max(Math.Abs(at.x) - 0.5f * patch.Size.x, Math.Abs(at.y) - 0.5f * patch.Size.y);
            if (near && beyond < tiny || crosses && Math.Abs(beyond) < tiny) unsure++;
            if (!crosses || beyond > 0f) return;
            if (a.z < 0f) forward++;
            else backward++;
        }

        [Test]
        public void SumsGoOnWhenThereIsPlaceForMoreAndBeginAnewForAnotherRequest()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Y | FluidAxes.Z;
            Patch[] patches = Patches(2);
            using (var rig = new QueryRig(settings, Flying(503)))
            using (var sums = new PatchSums())
            using (var retired = new RetiredBuffers())
            {
                var pass = new AnswerPatchesPass(rig.Shaders);
                FluidPatchResult[] Look(int count, int capacity, int particles, uint generation)
                {
                    GpuTest.Run(cmd => rig.Solver.RecordSteps(cmd, 10));
                    return rig.Ask<FluidPatchResult>(Words(patches, 0, generation), count, 0, (cmd, target, queries) =>
                    {
                        sums.Reserve(capacity, particles, retired);
                        pass.Record(cmd, target, queries, sums, count, 0);
                    });
                }
                Look(1, 1, 503, 3u);
                uint first = Look(1, 1, 503, 3u)[0].Forwards;
                FluidPatchResult[] second = Look(2, 20, 5000, 3u);
                Assert.That(first, Is.Positive);
                Assert.That(second[0].Forwards, Is.GreaterThan(first));
                Assert.That((second[1].Forwards, second[1].Backwards), Is.EqualTo((0u, 0u)), "new");
                Assert.That(Look(2, 20, 5000, 3u)[1].Particles, Is.Not.Zero);
                FluidPatchResult other = Look(2, 20, 5000, 4u)[0];
                Assert.That((other.Forwards, other.Backwards), Is.EqualTo((0u, 0u)));
            }
        }
    }
}
