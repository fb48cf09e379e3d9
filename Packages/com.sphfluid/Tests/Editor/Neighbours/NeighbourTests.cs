using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The neighbour loop finds every pair within h, once, from both sides.</summary>
    public sealed class NeighbourTests
    {
        static readonly Vector3 Domain = new Vector3(0.5f, 0.37f, 0.43f);

        [TestCase(1, true)]
        [TestCase(257, true)]
        [TestCase(2003, true)]
        [TestCase(2003, false)]
        public void PairsAgreeWithBruteForce(int count, bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = octant;
            using (var rig = new ThesisRig(settings, ParticleSets.Random(count, Domain, 0f, count)))
            {
                rig.RunNeighbourSetup();
                Check(rig, settings.SupportRadius);
            }
        }

        [Test]
        public void PairsAcrossEveryHalfCellAgreeWithBruteForce([Values] bool octant)
        {
            // A lattice of h/2 puts particles on cell faces and half-cell planes.
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = octant;
            FluidParticle[] lattice = ParticleSets.Lattice(new Vector3Int(19, 14, 16), 0.5f * settings.SupportRadius, 1e-7f, 9);
            using (var rig = new ThesisRig(settings, lattice))
            {
                rig.RunNeighbourSetup();
                Check(rig, settings.SupportRadius);
            }
        }

        [TestCase(1)]
        [TestCase(2003)]
        public void BothSearchesGiveTheSameDensitiesAndForces(int count)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            FluidParticle[] start = ParticleSets.Random(count, Domain, 2f, 3);
            Dictionary<uint, Vector4> octant = DensityAndForce(settings, start);
            settings.OctantSearch = false;
            Dictionary<uint, Vector4> rows = DensityAndForce(settings, start);
            double largest = octant.Values.Max(v => ((Vector3)v).magnitude);
            foreach (uint id in octant.Keys)
            {
                Assert.That(rows[id].w, Is.EqualTo(octant[id].w).Within(2e-5).Percent.Or.EqualTo(octant[id].w).Within(0.02), $"density of {id}");
                Assert.That((rows[id] - octant[id]).magnitude, Is.LessThan(1e-5 * largest + 0.02), $"force on {id}");
            }
        }

        [Test]
        public void EightCellsOfTheWrongSizeLosePairs()
        {
            // The octant rule on cells of h: the kernel searches 8, the grid is that of 27.
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = false;
            using (var rig = new ThesisRig(settings, ParticleSets.Random(1009, Domain, 0f, 8)))
            {
                FluidSolverSettings wrong = settings;
                wrong.OctantSearch = true;
                rig.State.Settings = wrong;
                rig.RunNeighbourSetup();
                Count(rig, settings.SupportRadius, out int pairs, out int missing, out int oneWay);
                Assert.That(missing, Is.GreaterThan(pairs / 20), "pairs lost");
                Assert.That(oneWay, Is.GreaterThan(0), "the force on one of them has no counterforce");
            }
        }

        static Dictionary<uint, Vector4> DensityAndForce(in FluidSolverSettings settings, FluidParticle[] start)
        {
            using (var rig = new ThesisRig(settings, start))
            {
                rig.RunNeighbourSetup();
                var pass = new CalculateForcePass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                FluidParticle[] particles = rig.ReadParticles();
                float[] density = rig.ReadDensity();
                Vector4[] force = rig.ReadForce();
                return Enumerable.Range(0, particles.Length).ToDictionary(i => particles[i].Id,
                    i => new Vector4(force[i].x, force[i].y, force[i].z, density[i]));
            }
        }

        static void Check(ThesisRig rig, double h)
        {
            Count(rig, h, out _, out int missing, out int oneWay);
            Assert.That(missing, Is.Zero, "pairs that differ from brute force");
            Assert.That(oneWay, Is.Zero, "one-way pairs");
        }

        static void Count(ThesisRig rig, double h, out int all, out int missing, out int oneWay)
        {
            FluidParticle[] particles = rig.ReadParticles();
            int words = (particles.Length + 31) / 32;
            uint[] pairs;
            uint[] visits;
            using (GraphicsBuffer pairBuffer = GpuBuffers.Create("Pairs", words * particles.Length, sizeof(uint)))
            using (GraphicsBuffer visitBuffer = GpuBuffers.Create("Visits", particles.Length, sizeof(uint)))
            {
                pairBuffer.SetData(new uint[words * particles.Length]);
                var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Neighbours/NeighbourPairs.compute"), "NeighbourPairs");
                GpuTest.Run(cmd =>
                {
                    ThesisBindings.SetNeighbours(cmd, kernel, rig.State);
                    kernel.SetInt(cmd, Shader.PropertyToID("_RowWords"), words);
                    kernel.SetInt(cmd, Shader.PropertyToID("_ParticleCount"), particles.Length);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Pairs"), pairBuffer);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Visits"), visitBuffer);
                    kernel.DispatchThreads(cmd, particles.Length);
                });
                pairs = GpuTest.Read<uint>(pairBuffer, words * particles.Length);
                visits = GpuTest.Read<uint>(visitBuffer, particles.Length);
            }

            all = 0;
            missing = 0;
            oneWay = 0;
            for (int i = 0; i < particles.Length; i++)
            {
                uint found = 0;
                for (int j = 0; j < particles.Length; j++)
                {
                    bool pair = Bit(pairs, words, i, j);
                    found += pair ? 1u : 0u;
                    double distance = ThesisReference.Distance(particles[i], particles[j]);

                    // Float rounding decides whether a pair at distance h is one; its weight is below 1e-9 of the nearest's.
                    bool onTheBorder = System.Math.Abs(distance - h) < 1e-5 * h;
                    all += distance < h ? 1 : 0;
                    missing += pair != distance < h && !onTheBorder ? 1 : 0;
                    oneWay += pair != Bit(pairs, words, j, i) && !onTheBorder ? 1 : 0;
                }

                Assert.That(visits[i], Is.EqualTo(found), $"particle {i} meets each neighbour once");
            }
        }

        static bool Bit(uint[] pairs, int words, int i, int j) => (pairs[i * words + j / 32] >> (j % 32) & 1u) != 0u;
    }
}
