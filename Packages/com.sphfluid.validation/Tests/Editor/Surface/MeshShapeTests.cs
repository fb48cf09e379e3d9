using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Angles, heights and normals of meshes that are known.</summary>
    public sealed class MeshShapeTests
    {
        [Test]
        public void AnglesOfEquilateralAndRightTriangles()
        {
            Assert.That(TriangleShapes.Of(ExactMeshes.Tetrahedron(), 1f).MeanAngle, Is.EqualTo(60.0).Within(1e-4));
            Assert.That(TriangleShapes.Of(ExactMeshes.Box(Vector3.zero, new Vector3(1f, 2f, 1f)), 1f).LeastAngle,
                Is.EqualTo(Math.Atan(0.5) * 180.0 / Math.PI).Within(1e-4));
        }

        [Test]
        public void CountsTrianglesWithoutArea()
        {
            SurfaceMesh whole = ExactMeshes.Tetrahedron();
            TriangleShapes shapes = TriangleShapes.Of(ExactMeshes.With(whole, whole.Indices.Concat(new[] { 0, 0, 1 })), 1f);

            Assert.That(shapes.ZeroArea, Is.EqualTo(1));
            Assert.That(shapes.LeastAngle, Is.Zero.Within(1e-6));
        }

        [Test]
        public void HeightsOfASlopeAreItsOwn()
        {
            const double degrees = 10.0;
            double rise = Math.Tan(degrees * Math.PI / 180.0);
            SurfaceMesh slope = ExactMeshes.Terrain(7, 5, (x, z) => 2f + (float)rise * x);
            var columns = new MeshColumns(new Rect(0f, 0f, 7f, 5f), 0.5f);

            double[] heights = columns.Heights(slope);
            ColumnStatistics statistics = ColumnStatistics.Of(heights, columns.Across, 0.5);

            Assert.That((columns.Across, columns.Deep), Is.EqualTo((14, 10)));
            Assert.That(statistics.Covered, Is.EqualTo(1.0));
            Assert.That(heights[3], Is.EqualTo(2.0 + rise * 0.5 * 3.37).Within(1e-6));
            Assert.That(heights[13 + 14], Is.EqualTo(heights[13]).Within(1e-6), "along z it is level");
            Assert.That(statistics.Slope, Is.EqualTo(degrees).Within(1e-4));
        }

        [Test]
        public void TheHighestOfSeveralCutsCounts()
        {
            SurfaceMesh mesh = ExactMeshes.Both(ExactMeshes.Box(Vector3.zero, new Vector3(4f, 1f, 4f)),
                ExactMeshes.Box(new Vector3(0f, 2f, 0f), new Vector3(2f, 3f, 4f)));
            var columns = new MeshColumns(new Rect(0f, 0f, 4f, 4f), 1f);

            ColumnStatistics statistics = ColumnStatistics.Of(columns.Heights(mesh), columns.Across, 1.0);

            Assert.That(statistics.Mean, Is.EqualTo(2.0).Within(1e-6));
            Assert.That(statistics.Rms, Is.EqualTo(1.0).Within(1e-6));
        }

        [Test]
        public void AHoleIsNotCovered()
        {
            SurfaceMesh whole = ExactMeshes.Terrain(10, 10, (x, z) => 0f);
            SurfaceMesh holed = ExactMeshes.With(whole, whole.Indices.Skip(6)); // the first square
            var columns = new MeshColumns(new Rect(0f, 0f, 10f, 10f), 1f);

            Assert.That(ColumnStatistics.Of(columns.Heights(holed), columns.Across, 1.0).Covered, Is.EqualTo(0.99).Within(1e-9));
        }

        [Test]
        public void ARasterWithoutColumnsIsRefused() =>
            Assert.Throws<ArgumentException>(() => new MeshColumns(new Rect(0f, 0f, 0.1f, 1f), 1f));

        [Test]
        public void SteadyMotionDoesNotFlickerAndNoiseDoes()
        {
            double[][] steady = Enumerable.Range(0, 5).Select(t => new[] { 0.2 * t, 1.0 - 0.1 * t }).ToArray();
            double[][] noisy = Enumerable.Range(0, 6).Select(t => new[] { t % 2 == 0 ? 0.1 : -0.1 }).ToArray();
            double[][] struck = { new[] { 0.0 }, new[] { 5.0 }, new[] { 0.0 } };

            Assert.That(ColumnStatistics.Flicker(steady, 1.0), Is.Zero.Within(1e-12));
            Assert.That(ColumnStatistics.Flicker(noisy, 1.0), Is.EqualTo(0.4).Within(1e-12));
            Assert.That(ColumnStatistics.Flicker(struck, 1.0), Is.NaN);
        }

        [Test]
        public void NormalsOfATorus()
        {
            SurfaceMesh torus = ExactMeshes.Torus(3f, 1f, 48);
            Func<Vector3, Vector3> truth = p => (p - 3f * new Vector3(p.x, 0f, p.z).normalized).normalized;
            Quaternion turned = Quaternion.AngleAxis(10f, Vector3.up);
            var level = new SurfaceMesh(torus.Positions, torus.Normals.Select(n => turned * n).ToArray(), torus.Indices);

            NormalError exact = NormalError.Of(torus, truth),
                error = NormalError.Of(level, p => Math.Abs(p.y) < 1e-3f ? truth(p) : Vector3.zero);

            Assert.That(exact.Shading, Is.Zero.Within(1e-3));
            Assert.That(exact.Faces, Is.InRange(0.1, 4.0), "faces are flat");
            Assert.That(error.Shading, Is.EqualTo(10.0).Within(1e-2));
        }
    }
}
