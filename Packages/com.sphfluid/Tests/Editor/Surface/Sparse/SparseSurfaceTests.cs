using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// The sparse surface as a whole: from particles to a mesh, with buffers that are too small, and against the
    /// thesis's dense surface.
    /// </summary>
    public sealed class SparseSurfaceTests
    {
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);
        private const float Spacing = 0.05f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(1, 0.1f)]
        [TestCase(63, 0.1f)]
        [TestCase(64, 0.1f)]
        [TestCase(65, 0.1f)]
        [TestCase(1009, 0.5f)]
        public void ThesisFieldGivesTheTrianglesOfTheDenseSurface(int count, float isoValue)
        {
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 0f, count);
            using (var solver = new FluidSolver(TestSettings.ByRule(Domain, Spacing), shaders, particles))
            {
                SurfaceGrid grid = SurfaceGridSize.Cells32.OverDomain(Domain);
                SurfaceMesh dense = ThesisSurfaceMesher.Extract(solver, shaders, SurfaceGridSize.Cells32, isoValue);
                SurfaceMesh sparse = FluidSurfaceMesher.Extract(solver, shaders,
                    SurfaceFieldSettings.Thesis(solver.Settings, grid, isoValue), grid);
                Assert.Greater(sparse.TriangleCount, 0);
                MeshChecks.AssertClosed(sparse);
                MeshChecks.AssertSameTriangles(dense, sparse, 1e-4f * Spacing);
            }
        }

        [Test]
        public void LoneParticleIsADrop([Values] FluidSurfaceQuality quality)
        {
            using (FluidSolver solver = Solver(new FluidParticle(new Vector3(0.11f, 0.07f, -0.05f), Vector3.zero, 0)))
            {
                SurfaceMesh mesh = FluidSurfaceMesher.Extract(solver, shaders, quality);
                MeshChecks.AssertClosed(mesh);
                MeshChecks.AssertSound(mesh);
                Assert.AreEqual(2, MeshChecks.EulerCharacteristic(mesh));
                foreach (Vector3 p in mesh.Positions) Assert.Less((p - new Vector3(0.11f, 0.07f, -0.05f)).magnitude, 0.9f * Spacing);
            }
        }

        [Test]
        public void LiquidOutOfTheDomainsReachGivesNothingAndNoWarning()
        {
            FluidParticle removed = new FluidParticle(Vector3.zero, Vector3.zero, 0) { Removed = 1f };
            using (FluidSolver solver = Solver(removed))
            using (var surface = new SparseSurface(shaders))
            {
                Record(surface, solver);
                Assert.AreEqual(0, surface.ReadMesh().TriangleCount);
                Assert.AreEqual(0, surface.Status.Blocks);
                Assert.IsNull(surface.TakeWarning());
            }
        }

        [Test]
        public void ParticlesThatAreNotNumbersAreReported()
        {
            using (FluidSolver solver = Solver(new FluidParticle(Vector3.zero, Vector3.zero, 0),
                new FluidParticle(0.2f * Vector3.one, Vector3.zero, 1)))
            using (var surface = new SparseSurface(shaders))
            {
                GpuTest.Run(solver.RecordNeighbourSetup);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(solver.Particles, 2);
                particles[1].Position.y = float.NaN;
                solver.Particles.SetData(particles);
                Record(surface, solver);
                MeshChecks.AssertClosed(surface.ReadMesh());
                Assert.AreEqual(1, surface.Status.NonFiniteParticles);
                StringAssert.Contains("not a number", surface.TakeWarning());
                Record(surface, solver);
                surface.ReadMesh();
                Assert.IsNull(surface.TakeWarning(), "reported once");
            }
        }

        [TestCase(SurfaceWalls.Closed)]
        [TestCase(SurfaceWalls.Open)]
        public void LiquidThatFillsTheDomain(SurfaceWalls walls)
        {
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(18, 14, 10), Spacing, 0f, 1);
            using (var solver = new FluidSolver(TestSettings.ByRule(Domain, Spacing), shaders, particles))
            {
                SurfaceMesh mesh = FluidSurfaceMesher.Extract(solver, shaders, FluidSurfaceQuality.Default, walls);
                MeshChecks.AssertClosed(mesh);
                Assert.AreEqual(walls == SurfaceWalls.Closed ? Domain.x * Domain.y * Domain.z : 0.0, mesh.Volume(),
                    0.01);
            }
        }

        [Test]
        public void BuffersGrowUntilTheSurfaceFits()
        {
            using (FluidSolver solver = Splash())
            using (var surface = new SparseSurface(shaders, 1, 10))
            {
                Record(surface, solver);
                Assert.Throws<InvalidOperationException>(() => surface.ReadMesh(), "blocks do not fit");
                Assert.IsFalse(surface.Status.IsComplete);
                Assert.AreEqual(0, surface.Status.Triangles);
                Record(surface, solver);
                Assert.Throws<InvalidOperationException>(() => surface.ReadMesh(), "triangles do not fit");
                Assert.Greater(surface.Status.Triangles, 10);
                Record(surface, solver);
                SurfaceMesh grown = surface.ReadMesh();
                MeshChecks.AssertClosed(grown);
                Assert.IsNull(surface.TakeWarning(), "growing is no trouble");
                SurfaceMesh atOnce = FluidSurfaceMesher.Extract(solver, shaders);
                CollectionAssert.AreEqual(atOnce.Positions, grown.Positions);
                CollectionAssert.AreEqual(atOnce.Normals, grown.Normals);
                CollectionAssert.AreEqual(atOnce.Indices, grown.Indices);
            }
        }

        [Test]
        public void SurfaceOverItsBudgetStaysAsItWasAndSaysSo()
        {
            const int budget = 500;
            using (FluidSolver drop = Solver(new FluidParticle(Vector3.zero, Vector3.zero, 0)))
            using (FluidSolver splash = Splash())
            using (var surface = new SparseSurface(shaders) { TriangleBudget = budget })
            {
                Record(surface, drop);
                SurfaceMesh before = surface.ReadMesh();
                uint drawn = GpuTest.Read<uint>(surface.DrawArguments, 1)[0];
                Record(surface, splash);
                Assert.Throws<FluidDeviceException>(() => surface.ReadMesh());
                Assert.AreEqual(drawn, GpuTest.Read<uint>(surface.DrawArguments, 1)[0],
                    "the last complete surface is drawn on");
                string warning = surface.TakeWarning();
                StringAssert.Contains($"its budget is {budget}", warning);
                StringAssert.Contains($"{surface.Status.Triangles} triangles", warning);
                StringAssert.Contains("Raise the triangle budget", warning);
                Record(surface, splash);
                Assert.LessOrEqual(surface.Triangles.IndexCapacity, 3 * budget, "the budget holds");
                Assert.IsNull(surface.TakeWarning(), "reported once");
                SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, splash.Settings);
                SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
                var thrown = Assert.Throws<FluidDeviceException>(() => surface.Extract(splash, field, grid,
                    SurfaceWalls.Closed));
                StringAssert.Contains("Raise the triangle budget", thrown.Message);
                surface.TriangleBudget = 0;
                Record(surface, splash);
                Assert.Greater(surface.ReadMesh().TriangleCount, before.TriangleCount);
            }
        }

        // As if a particle had not marked its block: the surface that runs into it brings it back.
        [Test]
        public void BlockThatWasNotMarkedIsFoundThroughItsNeighbours()
        {
            using (FluidSolver solver = Splash())
            using (var passes = new SurfacePasses(shaders))
            using (var blocks = new SurfaceBlocks())
            using (var triangles = new SurfaceTriangles())
            {
                SurfaceFieldSettings settings = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, solver.Settings);
                SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, settings.CellSize);
                blocks.Reserve(grid.Cells, 4096);
                triangles.Reserve(1 << 18, 1 << 20);
                var input = new SurfaceInput(solver, settings, grid, SurfaceWalls.Closed, blocks);
                GpuTest.Run(cmd => passes.RecordField(cmd, input));
                ForgetLastBlock(blocks);
                GpuTest.Run(cmd =>
                {
                    passes.RecordCount(cmd, input);
                    passes.RecordLateSamples(cmd, input);
                    passes.RecordCount(cmd, input);
                    passes.RecordTriangles(cmd, input, triangles);
                });
                var status = new SurfaceStatus(GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots));
                Assert.AreEqual(1, status.LateBlocks);
                Assert.AreEqual(0, status.OpenFaces);
                SurfaceMesh mended = triangles.Read(blocks, status);
                MeshChecks.AssertClosed(mended);
                CollectionAssert.AreEqual(FluidSurfaceMesher.Extract(solver, shaders).Indices, mended.Indices);
            }
        }

        [Test]
        public void SurfacesOfTwoLiquidsDoNotMix()
        {
            using (FluidSolver drop = Solver(new FluidParticle(Vector3.zero, Vector3.zero, 0)))
            using (FluidSolver splash = Splash())
            using (var first = new SparseSurface(shaders))
            using (var second = new SparseSurface(shaders))
            {
                SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, drop.Settings);
                SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
                GpuTest.Run(cmd =>
                {
                    first.Record(cmd, drop, field, grid, SurfaceWalls.Closed);
                    second.Record(cmd, splash, field, grid, SurfaceWalls.Closed);
                });
                Assert.AreEqual(2, MeshChecks.EulerCharacteristic(first.ReadMesh()));
                Assert.Greater(second.ReadMesh().TriangleCount, 1000);
                Assert.Greater(second.GpuBytes, 0);
            }
        }

        [Test]
        public void RecordingWithoutWhatItNeedsIsRefusedByName()
        {
            using (FluidSolver solver = Solver(new FluidParticle(Vector3.zero, Vector3.zero, 0)))
            using (var surface = new SparseSurface(shaders))
            using (var cmd = new CommandBuffer())
            {
                SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, solver.Settings);
                SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
                Assert.Throws<InvalidOperationException>(() => surface.ReadMesh());
                Assert.Throws<ArgumentNullException>(() => surface.Record(null, solver, field, grid,
                    SurfaceWalls.Closed));
                Assert.Throws<ArgumentNullException>(() => surface.Record(cmd, null, field, grid, SurfaceWalls.Closed));
                Assert.Throws<ArgumentException>(() => surface.Record(cmd, solver, default, grid, SurfaceWalls.Closed));
                Assert.Throws<ArgumentException>(() => surface.Record(cmd, solver, field, default,
                    SurfaceWalls.Closed));
                Assert.Throws<ArgumentNullException>(() => FluidSurfaceMesher.Extract(null, shaders));
            }
        }

        private static void ForgetLastBlock(SurfaceBlocks blocks)
        {
            uint[] counters = GpuTest.Read<uint>(blocks.Counters, SurfaceCounters.Slots);
            uint last = counters[SurfaceCounters.RoundCount] - 1;
            uint[] table = GpuTest.Read<uint>(blocks.Table, blocks.BlockCount);
            table[GpuTest.Read<uint>(blocks.List, (int)last + 1)[last]] = 0;
            foreach (int slot in new[] { SurfaceCounters.RoundCount, SurfaceCounters.BlocksListed,
                SurfaceCounters.BlocksRequested })
            {
                counters[slot] = last;
            }
            blocks.Table.SetData(table);
            blocks.Counters.SetData(counters);
        }

        private FluidSolver Splash() =>
            new FluidSolver(TestSettings.ByRule(Domain, Spacing), shaders, ParticleSets.Random(809, Domain, 0f, 3));

        private FluidSolver Solver(params FluidParticle[] particles) =>
            new FluidSolver(TestSettings.ByRule(Domain, Spacing), shaders, particles);

        private static void Record(SparseSurface surface, FluidSolver solver)
        {
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, solver.Settings);
            GpuTest.Run(cmd => surface.Record(cmd, solver, field, SurfaceGrid.OverDomain(Domain, field.CellSize),
                SurfaceWalls.Closed));
        }
    }
}
