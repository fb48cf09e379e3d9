using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The fused sort at sizes around its runs (2,048 pairs) and its longest strips (128 runs), and beside the thesis's own.
    /// </summary>
    public sealed class FusedBitonicSortTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(1023)]
        [TestCase(1024)]
        [TestCase(1025)]
        [TestCase(2047)]
        [TestCase(2048)]
        [TestCase(2049)]
        [TestCase(4096)]
        [TestCase(4099)]
        [TestCase(10007)]
        [TestCase(65536)]
        [TestCase(65537)]
        [TestCase(262145)]
        public void ResultIsTheSamePairsInOrder(int count)
        {
            CheckSort(SortPairs.Random(count, Math.Max(1, count / 8)));
        }

        [Test]
        [Explicit("A million pairs: with fewer, strips reach all distances but one.")]
        public void TwoDistancesThatNoStripReaches()
        {
            CheckSort(SortPairs.Random(1024 * 1024, 150000));
        }

        [TestCase(1021)]
        [TestCase(8191)]
        [TestCase(16384)]
        public void OrdersThatAreHardOnASort(int count)
        {
            CheckSort(SortPairs.Cells(count, i => i));
            CheckSort(SortPairs.Cells(count, i => count - i));
            CheckSort(SortPairs.Cells(count, i => 7));
            CheckSort(SortPairs.Cells(count, i => Math.Min(i, count - i)));
            CheckSort(SortPairs.Cells(count, i => i % 2 == 0 ? i : count - i));
            CheckSort(SortPairs.Cells(count, i => i == 0 ? int.MaxValue : 3));
            CheckSort(SortPairs.Cells(count, i => i / 2048 % 2));
            CheckSort(SortPairs.Cells(count, i => i % 2048));
        }

        // Dispatches: runs; then strips and runs of each level above; from 524,288 on single distances too.
        [TestCase(1024, 1)]
        [TestCase(2048, 1)]
        [TestCase(4096, 3)]
        [TestCase(65536, 11)]
        [TestCase(262144, 15)]
        [TestCase(524288, 18)]
        [TestCase(1048576, 22)]
        public void DispatchesOfASort(int count, int dispatches)
        {
            using (GraphicsBuffer data = GpuBuffers.Create("Data", 1, 8))
            using (var cmd = new UnityEngine.Rendering.CommandBuffer())
            {
                long before = ComputeKernel.DispatchesRecorded;
                Sort().Record(cmd, data, count);
                Assert.That(ComputeKernel.DispatchesRecorded - before, Is.EqualTo(dispatches));
            }
        }

        [Test]
        public void TheSwitchPicksTheSortAndTheLiquidIsTheSame()
        {
            FluidParticle[] thesis = Run(false, out long dispatches), fused = Run(true, out long fewer);
            Assert.That(fused, Is.EqualTo(thesis), "bit by bit");
            Assert.That(dispatches, Is.EqualTo(3 * (10 + 2 * 4)), "ten levels of blocks, four dispatches for each of two more");
            Assert.That(fewer, Is.EqualTo(3 * 3));
        }

        // Three neighbour setups with steps between; what they dispatch without the other passes.
        private FluidParticle[] Run(bool fused, out long dispatches)
        {
            var domain = new Vector3(1.1f, 0.7f, 0.9f);
            ThesisSwitches switches = ThesisSwitches.Corrected;
            switches.FusedSort = fused;
            FluidSolverSettings settings = TestSettings.ByRule(domain, 0.03f).With(switches);
            using (var solver = new FluidSolver(settings, shaders, ParticleSets.Random(2503, domain, 1f, 5)))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 1));
                long before = ComputeKernel.DispatchesRecorded;
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 3));
                dispatches = ComputeKernel.DispatchesRecorded - before - 3 * 8;
                return GpuTest.Read<FluidParticle>(solver.Particles, solver.ParticleCount);
            }
        }

        private FusedBitonicSortPass Sort() => new FusedBitonicSortPass(shaders, new BitonicSortPass(shaders));

        private void CheckSort(ulong[] pairs)
        {
            FusedBitonicSortPass sort = Sort();
            SortPairs.Check(pairs, (cmd, data, temp, count) => sort.Record(cmd, data, count));
        }
    }
}
