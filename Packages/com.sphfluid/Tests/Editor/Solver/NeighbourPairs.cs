using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the neighbour loop finds against brute force over all pairs and images.</summary>
    internal static class NeighbourPairs
    {
        /// <summary>Every pair is found, by both of its particles.</summary>
        public static void Check(ThesisRig rig)
        {
            Count(rig, out _, out int missing, out int oneWay);
            Assert.That(missing, Is.Zero, "pairs that differ from brute force");
            Assert.That(oneWay, Is.Zero, "one-way pairs");
        }

        /// <summary>
        /// Pairs within the support radius by brute force, those that the loop gets wrong, and those that only one side finds.
        /// </summary>
        public static void Count(ThesisRig rig, out int all, out int missing, out int oneWay)
        {
            double h = rig.State.Settings.SupportRadius;
            Vector3 period = rig.State.Settings.PeriodLength;
            FluidParticle[] particles = rig.ReadParticles();
            int words = (particles.Length + 31) / 32;
            uint[] pairs;
            uint[] visits;
            using (GraphicsBuffer pairBuffer = GpuBuffers.Create("Pairs", words * particles.Length, sizeof(uint)))
            using (GraphicsBuffer visitBuffer = GpuBuffers.Create("Visits", particles.Length, sizeof(uint)))
            {
                pairBuffer.SetData(new uint[words * particles.Length]);
                var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Solver/NeighbourPairs.compute"), "NeighbourPairs");
                GpuTest.Run(cmd =>
                {
                    GridNeighbours.Set(cmd, kernel, rig.State);
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
                    double distance = ThesisReference.Separation(particles[i], particles[j], period).Length;

                    // Float rounding decides whether a pair at distance h is one; its weight is below 1e-9 of the nearest's.
                    bool onTheBorder = System.Math.Abs(distance - h) < 1e-5 * h;
                    all += distance < h ? 1 : 0;
                    missing += pair != distance < h && !onTheBorder ? 1 : 0;
                    oneWay += pair != Bit(pairs, words, j, i) && !onTheBorder ? 1 : 0;
                }

                Assert.That(visits[i], Is.EqualTo(found), $"particle {i} visits each neighbour once");
            }
        }

        private static bool Bit(uint[] pairs, int words, int i, int j) => (pairs[i * words + j / 32] >> (j % 32) & 1u) != 0u;
    }
}
