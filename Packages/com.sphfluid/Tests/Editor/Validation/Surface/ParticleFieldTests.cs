using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The literature's fields where they are known.</summary>
    public sealed class ParticleFieldTests
    {
        static readonly SurfaceScale scale = new SurfaceScale();

        [Test]
        public void EigenvaluesOfAStretchedCloud()
        {
            Vector3 a = new Vector3(1f, 2f, 2f) / 3f, b = new Vector3(2f, 1f, -2f) / 3f, c = new Vector3(2f, -2f, 1f) / 3f;
            SymmetricTensor matrix = new SymmetricTensor().PlusOuter(a, 5.0).PlusOuter(b, 2.0).PlusOuter(c, 0.5);
            var values = new double[3];
            var vectors = new Vector3[3];

            matrix.Eigen(values, vectors);

            Assert.That(values.OrderBy(v => v), Is.EqualTo(new[] { 0.5, 2.0, 5.0 }).Within(1e-6));
            Assert.That(Math.Abs(Vector3.Dot(vectors[Array.IndexOf(values, values.Max())], a)), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(matrix.Form(3f * a), Is.EqualTo(45.0).Within(1e-4));
        }

        [Test]
        public void ALoneParticleHasRoundFields()
        {
            SurfaceState one = scale.Of(12f * Vector3.one, new[] { 6f * Vector3.one });
            SurfaceGrid grid = SurfaceGrid.OverDomain(one.Settings.DomainSize, one.Spacing);
            var sums = new NeighbourSums(one.Frames[0], one.Settings);

            float[] distance = new ZhuBridsonField().Sample(sums, grid), stretched = new AnisotropicField().Sample(sums, grid);

            Assert.That(sums.Counts[0], Is.Zero);
            Assert.That(distance[grid.Index(6, 6, 6)], Is.EqualTo(1.0).Within(1e-5));
            Assert.That(distance[grid.Index(7, 6, 6)], Is.EqualTo(0.5).Within(1e-5), "R is 2 dx");
            Assert.That(distance[grid.Index(6, 6, 8)], Is.Zero.Within(0.01), "the edge of the kernel");
            // A kernel of radius R/2 = dx: eight times poly6's height of 315/(64 π 8).
            Assert.That(stretched[grid.Index(6, 6, 6)], Is.EqualTo(315.0 / (64.0 * Math.PI)).Within(1e-5));
            Assert.That(stretched[grid.Index(6, 7, 6)], Is.Zero.Within(1e-5));
        }

        [Test]
        public void KernelsInALatticeStayRoundAndThoseOfAFilmLieFlat()
        {
            SurfaceState film = scale.Of(15f * Vector3.one, CaseLattice.Box(new Vector3Int(9, 1, 9), 1.0, new Vector3(3f, 7f, 3f)));
            var sums = new NeighbourSums(film.Frames[0], film.Settings);
            int centre = Array.IndexOf(film.Frames[0], film.Frames[0].OrderBy(p => p.sqrMagnitude).First());
            double unit = film.Spacing * film.Spacing;

            Assert.That(sums.Means[centre].magnitude / film.Spacing, Is.Zero.Within(1e-4));
            Assert.That(sums.Covariances[centre].Yy / unit, Is.Zero.Within(1e-6));
            Assert.That(sums.Covariances[centre].Xx / sums.Covariances[centre].Zz, Is.EqualTo(1.0).Within(1e-5));
        }

        [Test]
        public void LiquidGoesOnBehindWalls()
        {
            SurfaceState full = scale.Of(6f * Vector3.one, CaseLattice.Box(6 * Vector3Int.one, 1.0, Vector3.zero));
            var sums = new NeighbourSums(full.Frames[0], full.Settings);

            Assert.That(sums.Counts.Take(full.Frames[0].Length), Is.All.InRange(26, 32), "six more lie just at 2 dx");
            Assert.That(sums.Means.Take(full.Frames[0].Length).Max(m => m.magnitude) / full.Spacing, Is.Zero.Within(1e-4));
        }

        [TestCase(0.5f)]
        [TestCase(0.75f)]
        public void CalibrationPutsAPoolsTopHalfASpacingAboveItsLastLayer(float cell)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var variant = new LiteratureVariant(shaders, new ZhuBridsonField(), cell))
            using (var run = new SurfaceRun(SurfaceStates.Find("lattice-5").Build(scale), variant, shaders))
                Assert.That(run.RunToEnd().LevelError, Is.Zero.Within(0.03));
        }
    }
}
