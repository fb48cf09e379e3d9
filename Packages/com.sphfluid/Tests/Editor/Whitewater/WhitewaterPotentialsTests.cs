using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>How much air the liquid takes in, against the paper's sums over all particles in double precision.</summary>
    public sealed class WhitewaterPotentialsTests
    {
        [TestCase(FluidMethodKind.Standard, 1, FluidAxes.None)]
        [TestCase(FluidMethodKind.Standard, 255, FluidAxes.None)]
        [TestCase(FluidMethodKind.Standard, 256, FluidAxes.X | FluidAxes.Z)]
        [TestCase(FluidMethodKind.Standard, 257, FluidAxes.None)]
        [TestCase(FluidMethodKind.Standard, 1009, FluidAxes.Y)]
        [TestCase(FluidMethodKind.Standard, 4099, FluidAxes.None)]
        [TestCase(FluidMethodKind.Thesis, 1009, FluidAxes.None)]
        public void PotentialsAndBirthsAreThoseOfThePaper(FluidMethodKind method, int count, FluidAxes periodic)
        {
            const float amount = 1.5f, duration = 0.02f;
            FluidSolverSettings settings = WhitewaterRig.Settings(method, periodic);
            using (var rig = new WhitewaterRig(settings, ParticleSets.Random(count, 0.9f * WhitewaterRig.Domain, 2f, count)))
            {
                var means = new Vector3(30f, 2f, 7f);
                rig.Put(new WhitewaterPiece[0], (9, WhitewaterRig.Bits(means.x)), (10, WhitewaterRig.Bits(means.y)),
                    (11, WhitewaterRig.Bits(means.z)));
                rig.Measure(amount, duration);
                var reference = new WhitewaterReference(rig.Particles, settings);
                Vector4[] normals = GpuTest.Read<Vector4>(rig.Buffers.Normals, count),
                    found = GpuTest.Read<Vector4>(rig.Buffers.Potentials, count);
                int certain = 0;
                double births = 0.0;
                for (int i = 0; i < count; i++)
                {
                    births += found[i].w;
                    if (reference.IsDoubtful[i]) continue;
                    certain++;
                    Assert.AreEqual(reference.Air[i], found[i].x, 1e-4 * (1.0 + reference.Air[i]), $"trapped air of {i}");
                    Assert.AreEqual(reference.Crest[i], found[i].y, 1e-3, $"crest of {i}");
                    Assert.AreEqual(reference.Energy(i), found[i].z, 1e-5 * (1.0 + reference.Energy(i)), $"energy of {i}");
                    Assert.AreEqual(reference.Births(i, means, amount, duration), found[i].w, 2e-3, $"births of {i}");
                    Assert.AreEqual(0.0, ((Double3)new Vector3(normals[i].x, normals[i].y, normals[i].z) - reference.Normals[i]).Length,
                        1e-3, $"normal of {i}");
                }
                Assert.That(certain, Is.GreaterThan(0.95 * count));
                uint[] state = rig.State;
                Assert.AreEqual(births, state[3] / 256.0, 0.5 / 256.0 * (1 + count / 256) + 1e-3 * births, "births that are asked for");
                // The means go over the time since the start at first, so that the first is the largest itself.
                Assert.AreEqual(found.Max(f => f.x), WhitewaterRig.Number(state[9]), 1e-5f);
                Assert.AreEqual(found.Max(f => f.y), WhitewaterRig.Number(state[10]), 1e-5f);
                Assert.AreEqual(found.Max(f => f.z), WhitewaterRig.Number(state[11]), 1e-5f);
                if (count > 1000) Assert.That(found.Count(f => f.x > 0f && f.y > 0f && f.w > 0f), Is.GreaterThan(count / 100));
            }
        }

        [Test]
        public void LimitsAreMeansOverTheLastSecondsByTheLengthsOfFrames()
        {
            using (var rig = new WhitewaterRig(WhitewaterRig.Settings(FluidMethodKind.Standard),
                ParticleSets.Random(257, WhitewaterRig.Domain, 2f, 1)))
            {
                rig.Put(new WhitewaterPiece[0]);
                rig.Measure(1f, 0.5f);
                Vector4[] found = GpuTest.Read<Vector4>(rig.Buffers.Potentials, 257);
                double largest = found.Max(f => f.z);
                rig.Put(new WhitewaterPiece[0], (11, WhitewaterRig.Bits(10f)), (12, WhitewaterRig.Bits(0.5f)));
                rig.Measure(1f, 0.25f);
                Assert.AreEqual(10.0 + (largest - 10.0) / 3.0, WhitewaterRig.Number(rig.State[11]), 1e-4, "0.25 of 0.75 s");
                rig.Put(new WhitewaterPiece[0], (11, WhitewaterRig.Bits(10f)), (12, WhitewaterRig.Bits(2f)));
                rig.Measure(1f, 0.25f);
                Assert.AreEqual(10.0 + (largest - 10.0) / 8.0, WhitewaterRig.Number(rig.State[11]), 1e-4, "0.25 of 2 s");
            }
        }

        [Test]
        public void LiquidThatFallsAsOneBodyAndLiquidAtRestBringNothingForth()
        {
            foreach (float speed in new[] { 0f, 5f })
            {
                FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(8, 8, 8), WhitewaterRig.Spacing, 0.005f, 1);
                for (int i = 0; i < block.Length; i++) block[i].VelT0 = block[i].VelT1 = speed * Vector3.down;
                using (var rig = new WhitewaterRig(WhitewaterRig.Settings(FluidMethodKind.Standard), block))
                {
                    rig.Put(new WhitewaterPiece[0]);
                    rig.Measure(1f, 1f / 30f);
                    Vector4[] found = GpuTest.Read<Vector4>(rig.Buffers.Potentials, block.Length);
                    Assert.That(found.Max(f => f.x), Is.LessThan(1e-4f), "trapped air");
                    Assert.That(found.Count(f => f.w > 0f), Is.LessThan(speed > 0f ? block.Length / 8 : 1), "only its leading edges bulge");
                }
            }
        }
    }
}
