using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Which whitewater is left and which is born: the same to the piece, in the same order, as on the CPU.</summary>
    public sealed class WhitewaterListTests
    {
        private const float Duration = 1f / 50f, FoamLife = 3f;
        private const int Step = 4711;

        [TestCase(0, 1, 5000)]
        [TestCase(1, 255, 5000)]
        [TestCase(255, 256, 5000)]
        [TestCase(256, 257, 5000)]
        [TestCase(257, 1009, 5000)]
        [TestCase(1009, 4099, 20000)]
        [TestCase(70001, 1009, 80000)]
        [TestCase(1009, 4099, 1500)]
        [TestCase(1009, 257, 1009)]
        public void WhatIsLeftComesFirstThenWhatIsBorn(int count, int particles, int capacity)
        {
            WhitewaterPiece[] before = WhitewaterPiece.Random(count, WhitewaterRig.Domain, 1f, 0.4, count);
            using (var rig = new WhitewaterRig(WhitewaterRig.Settings(FluidMethodKind.Standard),
                ParticleSets.Random(particles, WhitewaterRig.Domain, 2f, particles), capacity))
            {
                float[] asked = Ask(rig, particles, 3.0);
                var requested = (uint)(asked.Sum(a => (double)a) * 256.0);
                rig.Put(before, (3, requested), (4, 10u), (5, 20u));
                WhitewaterPiece[] listed = rig.List(Step, FoamLife, Duration);

                WhitewaterPiece[] left = before.Where(p => p.Life > 0f).ToArray();
                float places = capacity - left.Length, share = requested / 256f > places ? places / (requested / 256f) : 1f;
                FluidParticle[] liquid = rig.Particles;
                Vector4[] normals = GpuTest.Read<Vector4>(rig.Buffers.Normals, particles);
                var born = new List<(FluidParticle parent, uint k, Vector3 normal)>();
                for (int i = 0; i < particles; i++)
                {
                    var births = (uint)(asked[i] * share + Unit(Hash(liquid[i].Id, Step, 0u).x));
                    for (uint k = 0; k < births && asked[i] > 0f; k++) born.Add((liquid[i], k, normals[i]));
                }
                Assert.AreEqual(Math.Min(left.Length + born.Count, capacity), listed.Length);
                for (int i = 0; i < left.Length; i++) Assert.AreEqual(left[i], listed[i], $"survivor {i}");
                for (int i = left.Length; i < listed.Length; i++) AssertBorn(born[i - left.Length], listed[i], $"birth {i - left.Length}");

                uint[] state = rig.State;
                int bornCount = listed.Length - left.Length;
                Assert.AreEqual(10 + bornCount, state[4], "births since the start");
                double expectedRefused = share < 1f ? Math.Max(0.0, Math.Round(requested / 256.0) - bornCount) : 0.0;
                Assert.AreEqual(20.0 + expectedRefused, state[5], 1.0, "refused since the start");
                CollectionAssert.AreEqual(new[] { (uint)(3 * listed.Length), 1u, 0u, 0u },
                    GpuTest.Read<uint>(rig.Buffers.DrawArguments, 4));
            }
        }

        [Test]
        public void WhereThereAreTooFewPlacesLiquidEverywhereBringsForthLess()
        {
            const int particles = 4096;
            using (var rig = new WhitewaterRig(WhitewaterRig.Settings(FluidMethodKind.Standard),
                ParticleSets.Random(particles, WhitewaterRig.Domain, 2f, 1), 2000))
            {
                float[] asked = Ask(rig, particles, 4.0);
                rig.Put(new WhitewaterPiece[0], (3, (uint)(asked.Sum(a => (double)a) * 256.0)));
                WhitewaterPiece[] listed = rig.List(Step, FoamLife, Duration);
                Assert.That(listed.Length, Is.InRange(1800, 2000));
                // A quarter of the domain each.
                for (int quarter = 0; quarter < 4; quarter++)
                {
                    int held = listed.Count(p => (p.Position.x > 0f ? 1 : 0) + (p.Position.z > 0f ? 2 : 0) == quarter);
                    Assert.That(held, Is.InRange(400, 600), $"quarter {quarter}");
                }
            }
        }

        [Test]
        public void NothingIsBornOfLiquidThatIsNotThere()
        {
            using (var rig = new WhitewaterRig(WhitewaterRig.Settings(FluidMethodKind.Standard), new FluidParticle[0], 300))
            {
                WhitewaterPiece[] before = WhitewaterPiece.Random(300, WhitewaterRig.Domain, 1f, 0.0, 1);
                rig.Put(before);
                rig.Measure(1f, Duration);
                CollectionAssert.AreEqual(before, rig.List(Step, FoamLife, Duration));
            }
        }

        // Gives each particle births, none to half of them, and normals to some.
        private static float[] Ask(WhitewaterRig rig, int particles, double most)
        {
            var random = new System.Random(particles);
            float[] asked = Enumerable.Range(0, particles)
                .Select(_ => random.NextDouble() < 0.5 ? 0f : (float)(most * random.NextDouble())).ToArray();
            rig.Buffers.Potentials.SetData(asked.Select(a => new Vector4(1f, 2f, 3f, a)).ToArray());
            rig.Buffers.Normals.SetData(asked.Select((_, i) => i % 3 == 0 ? Vector4.zero : new Vector4(0f, 1f, 0f, 5f)).ToArray());
            return asked;
        }

        // In a cylinder around its parent, moving on with it; its look depends on the hash.
        private static void AssertBorn((FluidParticle parent, uint k, Vector3 normal) birth, WhitewaterPiece piece, string what)
        {
            (uint x, uint y, uint z) place = Hash(birth.parent.Id, Step, 2u * birth.k + 1u),
                chance = Hash(birth.parent.Id, Step, 2u * birth.k + 2u);
            Double3 v = birth.parent.VelT1, along = v / v.Length;
            double age = Unit(chance.x) * Duration, half = 0.5 * WhitewaterRig.Spacing, reach = Math.Sqrt(Unit(place.x));
            Assert.AreEqual(age, piece.Age, 1e-6, what + ": age");
            Assert.AreEqual(FoamLife * (0.25 + 0.75 * Unit(chance.y)), piece.Life, 1e-5, what + ": life");
            Assert.AreEqual((chance.z & ~3u) | (birth.normal == Vector3.zero ? WhitewaterPiece.Bubble : WhitewaterPiece.Foam), piece.Seed,
                what + ": seed");
            Assert.AreEqual(birth.normal, piece.Normal, what + ": normal");
            Double3 spread = (Double3)piece.Velocity - v;
            Assert.AreEqual(0.0, Double3.Dot(spread, along), 1e-4, what + ": velocity along its parent's");
            Assert.AreEqual(0.25 * v.Length * reach, spread.Length, 1e-4, what + ": velocity across its parent's");
            Double3 offset = (Double3)piece.Position - birth.parent.Position;
            if (IsAtWall(piece.Position)) return;
            Assert.AreEqual(half * (2.0 * Unit(place.z) - 1.0), Double3.Dot(offset, along), 1e-5, what + ": along the cylinder");
            Double3 across = offset - Double3.Dot(offset, along) * along;
            Assert.AreEqual(half * reach + spread.Length * age, across.Length, 1e-5, what + ": from the cylinder's axis");
        }

        private static bool IsAtWall(Vector3 p) => Math.Abs(p.x) > 0.49999f * WhitewaterRig.Domain.x ||
            Math.Abs(p.y) > 0.49999f * WhitewaterRig.Domain.y ||
            Math.Abs(p.z) > 0.49999f * WhitewaterRig.Domain.z;

        private static float Unit(uint bits) => (bits >> 8) / 16777216f;

        // PCG3D of Jarzynski and Olano 2020.
        private static (uint x, uint y, uint z) Hash(uint x, uint y, uint z)
        {
            unchecked
            {
                x = x * 1664525u + 1013904223u;
                y = y * 1664525u + 1013904223u;
                z = z * 1664525u + 1013904223u;
                x += y * z;
                y += z * x;
                z += x * y;
                x ^= x >> 16;
                y ^= y >> 16;
                z ^= z >> 16;
                x += y * z;
                y += z * x;
                z += x * y;
                return (x, y, z);
            }
        }
    }
}
