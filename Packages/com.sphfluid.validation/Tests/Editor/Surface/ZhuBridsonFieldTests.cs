using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Zhu and Bridson's field where it is known.</summary>
    public sealed class ZhuBridsonFieldTests
    {
        private static readonly SurfaceScale scale = new SurfaceScale();

        [Test]
        public void FallsWithTheDistanceFromALoneParticle()
        {
            SurfaceState one = scale.Of(12f * Vector3.one, new[] { 6f * Vector3.one });
            SurfaceGrid grid = SurfaceGrid.OverDomain(one.Settings.DomainSize, one.Spacing);

            float[] field = ZhuBridsonField.Sample(one.Frames[0], one.Settings, grid);

            Assert.That(field[grid.Index(6, 6, 6)], Is.EqualTo(1.0).Within(1e-5));
            Assert.That(field[grid.Index(7, 6, 6)], Is.EqualTo(0.5).Within(1e-5), "R is 2 dx");
            Assert.That(field[grid.Index(6, 6, 8)], Is.Zero.Within(0.01), "the edge of the kernel");
            Assert.That(field[grid.Index(3, 6, 6)], Is.Zero);
        }

        [Test]
        public void LiquidGoesOnBehindWalls()
        {
            SurfaceState full = scale.Of(6f * Vector3.one, CaseLattice.Box(6 * Vector3Int.one, 1.0, Vector3.zero));
            SurfaceGrid grid = SurfaceGrid.OverDomain(full.Settings.DomainSize, full.Spacing);

            Assert.That(ZhuBridsonField.Sample(full.Frames[0], full.Settings, grid), Is.All.EqualTo(1f).Within(1e-3f),
                "all means lie at the vertices, at walls and in corners too");
        }

        [TestCase(0.5f)]
        [TestCase(0.75f)]
        public void CalibrationPutsAPoolsTopHalfASpacingAboveItsLastLayer(float cell)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var variant = new ZhuBridsonVariant(shaders, cell))
            using (var run = new SurfaceRun(SurfaceStateEntry.Find("packed").Build(scale), variant, shaders) { IsTimed = false })
                Assert.That(run.RunToEnd().LevelError, Is.Zero.Within(0.03));
        }
    }
}
