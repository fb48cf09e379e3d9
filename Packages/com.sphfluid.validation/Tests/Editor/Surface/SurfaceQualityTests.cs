using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the sparse surface in default quality makes of liquids whose surface is known; figures of all variants:
    /// Documentation~/surface-quality.md.
    /// </summary>
    public sealed class SurfaceQualityTests
    {
        private static readonly SurfaceScale scale = new SurfaceScale(true);
        private static readonly string[] synthetic = SurfaceStateEntry.All.Where(s => IsSynthetic(s.Build(scale)))
            .Select(s => s.Name).ToArray();

        private readonly Dictionary<string, SurfaceQuality> measured = new Dictionary<string, SurfaceQuality>();
        private FluidShaderSet shaders;
        private SurfaceVariant variant;

        [OneTimeSetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            variant = SurfaceVariantEntry.Find("default").Create(shaders);
        }

        [OneTimeTearDown]
        public void TearDown() => variant?.Dispose();

        [TestCaseSource(nameof(synthetic))]
        public void EverySurfaceIsClosed(string name) => AssertClosed(Measure(name));

        [TestCase("lattice-5", 0.025, 2.0)]
        [TestCase("packed", 0.035, 2.5)]
        [TestCase("lattice-20", 0.1, 7.0)]
        public void PoolsAreFlat(string name, double flatness, double slope)
        {
            SurfaceQuality quality = Measure(name);

            Assert.That(quality.Flatness, Is.LessThan(flatness));
            Assert.That(quality.Slope, Is.LessThan(slope));
            Assert.That(quality.ShadingError, Is.LessThan(slope + 1.0));
        }

        [TestCase("lattice-5", 0.01)]
        [TestCase("packed", 0.01)]
        [TestCase("full", 0.01)]
        [TestCase("sphere", 0.03)]
        [TestCase("torus", 0.03)]
        public void VolumesAreTheParticles(string name, double tolerance) =>
            Assert.That(Measure(name).Volume, Is.EqualTo(1.0).Within(tolerance));

        [Test]
        public void ARisingPoolDoesNotStickToTheGrid()
        {
            SurfaceQuality quality = Measure("rising");

            Assert.That(quality.LevelError, Is.Zero.Within(0.03));
            Assert.That(quality.Ripple, Is.LessThan(0.015));
        }

        [Test]
        public void EveryDropIsSeen()
        {
            SurfaceQuality drops = Measure("drops"), splash = Measure("splash");

            Assert.That((drops.DropsVisible, drops.Drops), Is.EqualTo((48, 48)));
            Assert.That(drops.DropRadius, Is.EqualTo(0.55).Within(0.05));
            Assert.That(splash.DropsVisible, Is.EqualTo(splash.Drops).And.GreaterThan(30));
        }

        [TestCase("film-5")]
        [TestCase("film-20")]
        public void AFilmOfOneLayerHasNoHoles(string name) => Assert.That(Measure(name).Covered, Is.GreaterThan(0.99));

        [Test]
        public void BodiesADiameterApartStayTwo() => Assert.That(Measure("two-spheres").MergeGap, Is.LessThan(1.25));

        [Test]
        public void OneParticleIsADrop()
        {
            SurfaceQuality quality = Measure(scale.Of(9f * Vector3.one, new[] { new Vector3(4.3f, 4.9f, 4.6f) }));

            AssertClosed(quality);
            Assert.That((quality.Euler, quality.Components), Is.EqualTo((2.0, 1.0)));
        }

        [Test]
        public void WhereTheFieldStaysBelowItsIsoValueThereIsNoSurface()
        {
            using (SurfaceVariant thesis = SurfaceVariantEntry.Find("thesis-sparse-0.75").Create(shaders))
            using (var run = new SurfaceRun(SurfaceStateEntry.Find("drops").Build(scale), thesis, shaders) { IsTimed = false })
            {
                SurfaceQuality quality = run.RunToEnd();
                Assert.That((quality.Triangles, quality.Vertices, quality.DropsVisible), Is.EqualTo((0.0, 0.0, 0)));
            }
        }

        [Test]
        public void ASettledPoolIsFlatAndStill()
        {
            SurfaceQuality quality = Measure(Solved(SolvedStates.Settled(scale, new Vector3Int(12, 5, 12)), 4));

            AssertClosed(quality);
            Assert.That(quality.Volume, Is.EqualTo(1.0).Within(0.05));
            Assert.That(quality.Flatness, Is.LessThan(0.03));
            Assert.That(quality.Flicker, Is.LessThan(0.01));
        }

        [Test]
        public void ADamBreakIsClosedAndDoesNotFlicker()
        {
            SurfaceQuality quality = Measure(Solved(SolvedStates.DamBreak(scale), 4));

            AssertClosed(quality);
            Assert.That(quality.Flicker, Is.LessThan(0.4), "the motion itself has 0.2 to 0.3");
        }

        private static bool IsSynthetic(SurfaceState state) => state.Prepare == null && state.Field == null;

        private SurfaceQuality Measure(string name)
        {
            if (!measured.TryGetValue(name, out SurfaceQuality quality))
            {
                measured.Add(name, quality = Measure(SurfaceStateEntry.Find(name).Build(scale)));
            }
            return quality;
        }

        private SurfaceQuality Measure(SurfaceState state)
        {
            using (var run = new SurfaceRun(state, variant, shaders) { IsTimed = false })
                return run.RunToEnd();
        }

        private SurfaceState Solved(SurfaceState state, int frames)
        {
            var work = new SessionWork(state.Prepare(shaders));
            while (state.Frames.Count < frames) work.Step();
            work.Clear();
            return state;
        }

        private static void AssertClosed(SurfaceQuality quality)
        {
            Assert.That((quality.OpenEdges, quality.NonManifoldEdges, quality.FlippedEdges, quality.ZeroArea), Is.EqualTo((0, 0, 0, 0)));
            Assert.That(quality.LateBlocks, Is.Zero, "the particles mark all blocks that the surface passes");
            Assert.That(quality.Triangles, Is.Positive);
        }
    }
}
