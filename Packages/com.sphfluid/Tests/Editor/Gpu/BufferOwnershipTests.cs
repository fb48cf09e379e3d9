using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Whoever makes GPU buffers counts and releases all of them.</summary>
    public sealed class BufferOwnershipTests
    {
        private const float Spacing = 0.1f;
        private static readonly Vector3 Domain = new Vector3(1f, 1.2f, 0.9f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(FluidMethodKind.Standard, false)]
        [TestCase(FluidMethodKind.Standard, true)]
        [TestCase(FluidMethodKind.Thesis, false)]
        public void ASolverCountsAndReleasesItsBuffers(FluidMethodKind method, bool neighbourList)
        {
            FluidSolverSettings settings = method == FluidMethodKind.Standard
                ? BodyRig.Water(Domain, Spacing, 0.5f) : TestSettings.ByRule(Domain, Spacing);
            if (method == FluidMethodKind.Standard)
            {
                settings = settings.WithOwn((ref StandardSettings own) => own.NeighbourList = neighbourList);
            }
            var solver = new FluidSolver(settings, shaders, ParticleSets.Random(257, Domain, 0f, 1));
            GpuTest.Run(cmd => solver.RecordSteps(cmd, 2));
            Assert.AreEqual(ReachableBuffers.Bytes(solver.State), solver.GpuBytes);
            AssertReleased(solver, solver);
        }

        [Test]
        public void ASparseSurfaceCountsAndReleasesItsBuffers()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            var surface = new SparseSurface(shaders);
            using (var solver = new FluidSolver(settings, shaders, ParticleSets.Random(257, Domain, 0f, 1)))
                GpuTest.Run(cmd => surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed));
            Assert.AreEqual(ReachableBuffers.Bytes(surface), surface.GpuBytes);
            AssertReleased(surface, surface);
        }

        [Test]
        public void TheBlocksOfASurfaceCountTheirBuffers()
        {
            using (var blocks = new SurfaceBlocks())
            {
                Assert.AreEqual(0, blocks.Bytes, "nothing was reserved");
                blocks.Reserve(new Vector3Int(20, 30, 40), 64);
                Assert.AreEqual(ReachableBuffers.Bytes(blocks), blocks.Bytes);
            }
        }

        [Test]
        public void ADenseSurfaceReleasesItsBuffers()
        {
            var grid = new SurfaceGrid(-0.5f * Vector3.one, Vector3.one, 16);
            var polygoniser = new SurfacePolygoniser(shaders);
            SurfaceField field = SurfaceTestScene.Field(shaders, grid, p => 0.8f - p.magnitude);
            polygoniser.Polygonise(field);
            Assert.AreEqual(ReachableBuffers.Bytes(field), field.GpuBytes);
            AssertReleased(polygoniser, polygoniser);
            AssertReleased(field, field);
        }

        private static void AssertReleased(object owner, IDisposable disposable)
        {
            IReadOnlyList<GraphicsBuffer> held = ReachableBuffers.Of(owner);
            Assert.Greater(held.Count, 0);
            Assert.IsTrue(held.All(b => b.IsValid()), "all live before");
            disposable.Dispose();
            Assert.IsEmpty(held.Where(b => b.IsValid()).Select(b => $"{b.count} x {b.stride} bytes"), "left on the GPU");
        }
    }
}
