using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// PrepareSurfaceParticles marks every block that the surface crosses; the truth comes from sampling all blocks.
    /// </summary>
    public sealed class BlockMarkingTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3Int Lattice = new Vector3Int(20, 16, 14);
        private static readonly Vector3 Domain = Spacing * (Vector3)Lattice;

        private static readonly string[] States = { "pool", "splash", "film", "drops", "coincident", "full", "bubbles" };

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void EveryBlockThatTheSmoothSurfaceCrossesIsMarked([ValueSource(nameof(States))] string state,
            [Values(FluidSurfaceQuality.Cheap, FluidSurfaceQuality.Default, FluidSurfaceQuality.High)] FluidSurfaceQuality quality)
        {
            FluidSolverSettings settings = Settings();
            SurfaceFieldSettings field = SurfaceFieldSettings.For(quality, settings);
            AssertCovered(State(state), settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        [TestCase("splash")]
        [TestCase("film")]
        [TestCase("bubbles")]
        public void EveryBlockThatTheAnisotropicSurfaceCrossesIsMarked(string state)
        {
            FluidSolverSettings settings = Settings();
            SurfaceFieldSettings field = SurfaceFieldSettings.Anisotropic(settings, 0.75f);
            AssertCovered(State(state), settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        [Test]
        public void EveryBlockThatTheThesisSurfaceCrossesIsMarked([ValueSource(nameof(States))] string state)
        {
            FluidSolverSettings settings = Settings();
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, 32);
            AssertCovered(State(state), settings, SurfaceFieldSettings.Thesis(settings, grid), grid);
        }

        [Test]
        public void SurfaceThatRunsOverAPeriodicFaceIsMarkedOnBothSides()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Z;
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            FluidParticle[] ball = Array.FindAll(State("full"),
                p => (p.Position - 0.5f * new Vector3(Domain.x, 0f, Domain.z)).magnitude < 4f * Spacing);
            AssertCovered(ball, settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        // Amid a pool no block is active; without closed walls none along them either, but for some at the domain's
        // edges.
        [Test]
        public void BlocksInsideTheLiquidAreNotMarked()
        {
            FluidSolverSettings settings = Settings();
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.High, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            using (var rig = new BlockFieldRig(shaders, settings,
                ParticleSets.Lattice(Lattice, Spacing, 0.02f * Spacing, 3)))
            {
                rig.Record(field, grid);
                Assert.IsFalse(rig.Read().ContainsKey(BlockHolding(grid, Vector3.zero)));
                rig.Record(field, grid, wallsClosed: false);
                Assert.Less(rig.Counters()[SurfaceCounters.BlocksRequested], rig.Blocks.BlockCount / 4);
                Assert.IsFalse(rig.Read().ContainsKey(BlockHolding(grid, new Vector3(0f, -0.49f * Domain.y, 0f))));
            }
        }

        private static Vector3Int BlockHolding(SurfaceGrid grid, Vector3 position)
        {
            Vector3 cell = grid.CellSize, from = position - grid.Minimum;
            return new Vector3Int(((int)(from.x / cell.x) + 1) / 8, ((int)(from.y / cell.y) + 1) / 8,
                ((int)(from.z / cell.z) + 1) / 8);
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = false;
            return settings;
        }

        private void AssertCovered(FluidParticle[] particles, in FluidSolverSettings settings, in SurfaceFieldSettings field,
            SurfaceGrid grid)
        {
            using (var rig = new BlockFieldRig(shaders, settings, particles))
            {
                rig.Record(field, grid);
                var marked = new HashSet<Vector3Int>(rig.Read().Keys);
                rig.RecordAll(field, grid);
                int crossed = 0, missed = 0;
                foreach (KeyValuePair<Vector3Int, float[]> block in rig.Read())
                {
                    if (!BlockFieldRig.IsCrossed(block.Key, block.Value, field.IsoValue, grid.Cells)) continue;
                    crossed++;
                    missed += marked.Contains(block.Key) ? 0 : 1;
                }
                Assert.AreEqual(0, missed, $"of {crossed} blocks with a surface; {marked.Count} are marked");
                TestContext.WriteLine($"{crossed} of {marked.Count} marked blocks hold the surface");
            }
        }

        private static FluidParticle[] State(string name)
        {
            var random = new System.Random(5);
            switch (name)
            {
                case "pool":
                    return Pool(8, 0.05f);
                case "splash":
                    return With(Pool(6, 0.15f), 250, _ => Vector3.Scale(ParticleSets.RandomVector(random), Domain));
                case "film":
                    return Array.FindAll(Jittered(0.2f),
                        p => Mathf.Abs(p.Position.y - 0.5f * Spacing) < 0.45f * Spacing);
                case "drops":
                    return ParticleSets.Random(40, Domain, 0f, 9);
                case "coincident":
                    return With(Pool(8, 0.05f), 500, _ => new Vector3(0.11f, -0.3f, 0.03f));
                case "full":
                    return Jittered(0.05f);
                default: // bubbles of 1.6 spacings, one of them cut by blocks
                    return Array.FindAll(Jittered(0.05f),
                        p => (p.Position - new Vector3(0.1f, 0.1f, 0.1f)).magnitude > 1.6f * Spacing &&
                        (p.Position + new Vector3(0.3f, 0.2f, 0.1f)).magnitude > 1.6f * Spacing);
            }
        }

        private static FluidParticle[] Jittered(float jitter) => ParticleSets.Lattice(Lattice, Spacing, jitter * Spacing, 3);

        private static FluidParticle[] Pool(int layers, float jitter) =>
            Array.FindAll(Jittered(jitter), p => p.Position.y < -0.5f * Domain.y + layers * Spacing);

        private static FluidParticle[] With(FluidParticle[] particles, int count, Func<int, Vector3> position)
        {
            var all = new List<FluidParticle>(particles);
            for (int i = 0; i < count; i++) all.Add(new FluidParticle(position(i), Vector3.zero, (uint)(all.Count + 100000)));
            return all.ToArray();
        }
    }
}
