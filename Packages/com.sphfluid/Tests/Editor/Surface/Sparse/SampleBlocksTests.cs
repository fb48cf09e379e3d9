using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// SampleBlocks, after PrepareSurfaceParticles, against sums over all particles in double precision, and against
    /// the dense field.
    /// </summary>
    public sealed class SampleBlocksTests
    {
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);
        private const float Spacing = 0.05f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        [TestCase(1, FluidSurfaceQuality.Default)]
        [TestCase(255, FluidSurfaceQuality.Cheap)]
        [TestCase(256, FluidSurfaceQuality.Default)]
        [TestCase(257, FluidSurfaceQuality.High)]
        [TestCase(1009, FluidSurfaceQuality.Default, false)]
        [TestCase(1009, FluidSurfaceQuality.Cheap, true, FluidAxes.X)]
        [TestCase(1009, FluidSurfaceQuality.Default, false, FluidAxes.X | FluidAxes.Z)]
        [TestCase(509, FluidSurfaceQuality.High, true, FluidAxes.X | FluidAxes.Y)]
        public void SmoothFieldEqualsTheSumOverAllParticles(int count, FluidSurfaceQuality quality, bool octant = true,
            FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = Settings(octant, periodic);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(quality, settings);
            CompareWithReference(ParticleSets.Random(count, Domain, 0f, count), settings, field,
                SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        // Two of three fly as one, so that many kernels are stretched; others leave.
        [TestCase(63, FluidSurfaceQuality.Default)]
        [TestCase(257, FluidSurfaceQuality.High)]
        [TestCase(701, FluidSurfaceQuality.Cheap, FluidAxes.X)]
        [TestCase(1009, FluidSurfaceQuality.Default)]
        public void FlowingFieldEqualsTheSumOverAllParticles(int count, FluidSurfaceQuality quality, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = Settings(true, periodic);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(quality, settings).WithSpray(true);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            CompareWithReference(ListSprayTests.Flowing(count, Domain), settings, field, grid, 2e-3);
        }

        // Spacings far from 1 m on either side of it: a length taken for its square or its inverse shows.
        [TestCase(1f / 64f)]
        [TestCase(64f)]
        public void LiquidOfAnyScaleHasTheFieldOfItsScale(float scale)
        {
            FluidSolverSettings settings = TestSettings.ByRule(scale * Domain, scale * Spacing);
            settings.OctantSearch = false;
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(scale * Domain, field.CellSize);
            CompareWithReference(ParticleSets.Random(701, scale * Domain, 0f, 21), settings, field, grid);
        }

        [TestCase(1, false, FluidAxes.None)]
        [TestCase(257, true, FluidAxes.None)]
        [TestCase(1009, false, FluidAxes.X | FluidAxes.Z)]
        public void AnisotropicFieldEqualsTheSumOverAllParticles(int count, bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(octant, periodic);
            SurfaceFieldSettings field = SurfaceFieldSettings.Anisotropic(settings, 0.75f);
            CompareWithReference(ParticleSets.Random(count, Domain, 0f, count), settings, field,
                SurfaceGrid.OverDomain(Domain, field.CellSize), 1e-3);
        }

        [TestCase(1, 11)]
        [TestCase(257, 32)]
        [TestCase(1009, 17, false)]
        [TestCase(1009, 29, true, FluidAxes.Y)]
        public void ThesisFieldEqualsTheSumOverAllParticles(int count, int cells, bool completed = true,
            FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = Settings(true, periodic);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, cells);
            SurfaceFieldSettings field = SurfaceFieldSettings.Thesis(settings, grid, 0.5f, completed);
            CompareWithReference(ParticleSets.Random(count, Domain, 0f, count), settings, field, grid);
        }

        [Test]
        public void StandardMethodServesASmallerRadiusThanItsOwn()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.LiquidHeight = Domain.y;
            input.LiquidDepth = Domain.y;
            FluidSolverSettings settings = FluidRules.Derive(input);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            Assert.Less(field.SupportRadius, settings.SupportRadius);
            CompareWithReference(ParticleSets.Random(701, Domain, 0f, 5), settings, field,
                SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        [TestCase(32, true, FluidAxes.None)]
        [TestCase(47, false, FluidAxes.None)]
        [TestCase(32, true, FluidAxes.X)]
        public void ThesisFieldIsTheDenseField(int cells, bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(octant, periodic);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, cells);
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(1500, Domain, 0f, 7)))
            using (var dense = new SurfaceField(shaders, grid))
            {
                GpuTest.Run(cmd => dense.Record(cmd, rig.Solver));
                float[] expected = GpuTest.Read<float>(dense.Values, grid.VertexCount);
                rig.RecordAll(SurfaceFieldSettings.Thesis(settings, grid), grid);
                int compared = 0;
                foreach (KeyValuePair<Vector3Int, float[]> block in rig.Read())
                {
                    for (int i = 0; i < block.Value.Length; i++)
                    {
                        Vector3Int s = BlockFieldRig.SampleAt(block.Key, i);
                        bool inGrid = Math.Min(s.x, Math.Min(s.y, s.z)) >= 0 && s.x <= cells && s.y <= cells &&
                            s.z <= cells;
                        float value = inGrid ? expected[grid.Index(s.x, s.y, s.z)] : 0f;
                        Assert.AreEqual(value, block.Value[i], 1e-5f * Math.Max(1f, value), $"sample {s}");
                        compared++;
                    }
                }
                Assert.GreaterOrEqual(compared, (cells + 1) * (cells + 1) * (cells + 1));
            }
        }

        [TestCase(FluidSurfaceQuality.Cheap, FluidAxes.None)]
        [TestCase(FluidSurfaceQuality.Default, FluidAxes.None)]
        [TestCase(FluidSurfaceQuality.High, FluidAxes.None)]
        [TestCase(FluidSurfaceQuality.Default, FluidAxes.X | FluidAxes.Y)]
        public void BlocksAgreeOnTheSamplesThatTheyShareToTheLastBit(FluidSurfaceQuality quality, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(false, periodic);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(quality, settings);
            AssertSharedSamplesEqual(settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        [Test]
        public void BlocksOfTheAnisotropicFieldAgreeToTheLastBit()
        {
            FluidSolverSettings settings = Settings(false, FluidAxes.None);
            SurfaceFieldSettings field = SurfaceFieldSettings.Anisotropic(settings);
            AssertSharedSamplesEqual(settings, field, SurfaceGrid.OverDomain(Domain, field.CellSize));
        }

        [Test]
        public void BlocksOfTheThesisFieldAgreeToTheLastBit()
        {
            FluidSolverSettings settings = Settings(true, FluidAxes.None);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, 41);
            AssertSharedSamplesEqual(settings, SurfaceFieldSettings.Thesis(settings, grid), grid);
        }

        // 500 particles at one point: one drop of the smooth field, a high peak of the thesis's.
        [Test]
        public void CoincidentParticlesNeitherOverflowNorVanish()
        {
            FluidSolverSettings settings = Settings(false, FluidAxes.None);
            var particles = new FluidParticle[500];
            for (int i = 0; i < particles.Length; i++)
            {
                particles[i] = new FluidParticle(new Vector3(0.01f, -0.02f, 0.03f), Vector3.zero, (uint)i);
            }
            SurfaceFieldSettings smooth = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            CompareWithReference(particles, settings, smooth, SurfaceGrid.OverDomain(Domain, smooth.CellSize), 1e-3);
            var grid = new SurfaceGrid(-0.5f * Domain, Domain, 32);
            CompareWithReference(particles, settings, SurfaceFieldSettings.Thesis(settings, grid), grid, 1e-3);
        }

        [Test]
        public void ParticlesThatAreNotNumbersAreCountedAndSkipped()
        {
            FluidSolverSettings settings = Settings(false, FluidAxes.None);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(300, Domain, 0f, 3)))
            {
                GpuTest.Run(rig.Solver.RecordNeighbourSetup);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, 300);
                particles[17].Position.x = float.NaN;
                particles[99].Position = Vector3.one * float.PositiveInfinity;
                particles[200].Position.z = float.NegativeInfinity;
                particles[150].Removed = 1f;
                rig.Solver.Particles.SetData(particles); // as the solver left them: what was set up stays
                rig.Record(field, grid);
                Assert.AreEqual(3u, rig.Counters()[SurfaceCounters.NonFinite]);
                var others = new List<FluidParticle>(particles);
                others.RemoveAll(p => p.IsRemoved || float.IsNaN(p.Position.sqrMagnitude) ||
                    float.IsInfinity(p.Position.sqrMagnitude));
                // What is removed stands behind all others and in no cell; here it does not, so that its neighbours
                // still count it.
                others.Add(particles[150]);
                Compare(rig.Read(), new SurfaceFieldReference(others, settings, field, grid), 2e-4,
                    Near(particles[150].Position, grid, settings));
            }
        }

        private FluidSolverSettings Settings(bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = octant;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        private void CompareWithReference(FluidParticle[] particles, in FluidSolverSettings settings,
            in SurfaceFieldSettings field, SurfaceGrid grid, double tolerance = 2e-4)
        {
            using (var rig = new BlockFieldRig(shaders, settings, particles))
            {
                rig.Record(field, grid);
                uint[] counters = rig.Counters();
                Assert.Greater(counters[SurfaceCounters.BlocksListed], 0u);
                Assert.AreEqual(counters[SurfaceCounters.BlocksRequested], counters[SurfaceCounters.BlocksListed]);
                Assert.AreEqual(0u, counters[SurfaceCounters.NonFinite]);
                Compare(rig.Read(), new SurfaceFieldReference(particles, settings, field, grid), tolerance, _ => false);
            }
        }

        private static void Compare(Dictionary<Vector3Int, float[]> blocks, SurfaceFieldReference reference, double tolerance,
            Predicate<Vector3Int> skip)
        {
            var random = new System.Random(11);
            var places = new List<Vector3Int>(blocks.Keys);
            double largest = 0.0;
            for (int n = 0; n < 250; n++)
            {
                Vector3Int block = places[random.Next(places.Count)];
                int i = random.Next(SurfaceBlocks.SamplesPerBlock);
                Vector3Int s = BlockFieldRig.SampleAt(block, i);
                if (skip(s)) continue;
                double expected = reference.Value(s);
                Assert.AreEqual(expected, blocks[block][i], tolerance * Math.Max(1.0, expected), $"sample {s}");
                largest = Math.Max(largest, expected);
            }
            Assert.Greater(largest, 0.0, "the samples are in the liquid");
        }

        private static Predicate<Vector3Int> Near(Vector3 position, SurfaceGrid grid, FluidSolverSettings settings) =>
            s => (grid.Position(s.x, s.y, s.z) - position).magnitude < settings.SupportRadius + 3f * settings.Spacing;

        private void AssertSharedSamplesEqual(in FluidSolverSettings settings, in SurfaceFieldSettings field, SurfaceGrid grid)
        {
            using (var rig = new BlockFieldRig(shaders, settings, ParticleSets.Random(3000, Domain, 0f, 13)))
            {
                rig.RecordAll(field, grid);
                var bits = new Dictionary<Vector3Int, int>();
                int shared = 0;
                foreach (KeyValuePair<Vector3Int, float[]> block in rig.Read())
                {
                    for (int i = 0; i < block.Value.Length; i++)
                    {
                        Vector3Int s = BlockFieldRig.SampleAt(block.Key, i);
                        int value = BitConverter.SingleToInt32Bits(block.Value[i]);
                        if (bits.TryGetValue(s, out int other))
                        {
                            Assert.AreEqual(other, value, $"sample {s}");
                            shared++;
                        }
                        else
                        {
                            bits.Add(s, value);
                        }
                    }
                }
                Assert.Greater(shared, 1000);
            }
        }
    }
}
