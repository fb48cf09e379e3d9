using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Triangles as layers of particles: spacing, gaps and side.</summary>
    public sealed class SurfaceSamplerTests
    {
        private const float Spacing = 0.1f;

        private static readonly Bounds Everywhere = new Bounds(Vector3.zero, 20f * Vector3.one);

        private static List<Vector3> Sample(TriangleMesh mesh, int layers = 1, SpacedPoints taken = null, SpacedPoints liquid = null) =>
            SurfaceSampler.Sample(mesh, Spacing, layers, Everywhere, taken ?? new SpacedPoints(Spacing), liquid);

        private static IEnumerable<TestCaseData> Meshes()
        {
            TestCaseData Case(string name, TriangleMesh mesh) => new TestCaseData(mesh).SetName($"{{m}}({name})");
            yield return Case("box", TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.5f, 0.7f, 0.3f))));
            yield return Case("box of no whole spacings, turned",
                TriangleMesh.Box(Matrix4x4.TRS(new Vector3(0.31f, -0.2f, 0.1f), Quaternion.Euler(20f, 30f, 40f),
                    new Vector3(0.53f, 0.77f, 0.36f))));
            yield return Case("thin plate", TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.6f, 0.04f, 0.6f))));
            yield return Case("sphere", TestMeshes.Sphere(0.4f, 0.01f));
            yield return Case("small sphere", TestMeshes.Sphere(0.07f, 0.01f));
            yield return Case("less than a spacing", TestMeshes.Sphere(0.02f, 0.002f));
            yield return Case("sheet", TestMeshes.Sheet());
            yield return Case("vessel whose faces look inward", Inward(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.5f, 0.7f, 0.6f)))));
        }

        private static TriangleMesh Inward(TriangleMesh mesh) => new TriangleMesh(mesh.Vertices, mesh.Indices.Reverse().ToArray());

        // Places on the triangles, a fifth of a spacing apart at most.
        private static IEnumerable<Vector3> Surface(TriangleMesh mesh)
        {
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                int steps = 1 + (int)(5f * Mathf.Max((b - a).magnitude, (c - a).magnitude) / Spacing);
                for (int i = 0; i <= steps; i++)
                    for (int j = 0; i + j <= steps; j++) yield return a + (b - a) * (i / (float)steps) + (c - a) * (j / (float)steps);
            }
        }

        [TestCaseSource(nameof(Meshes))]
        public void EveryPlaceOfTheSurfaceHasAParticleWithinASpacing(TriangleMesh mesh)
        {
            List<Vector3> points = Sample(mesh);

            float widest = Surface(mesh).Max(place => points.Min(p => (p - place).magnitude));
            Assert.That(widest, Is.LessThan(Spacing));
        }

        [TestCaseSource(nameof(Meshes))]
        public void NoTwoParticlesAreNearerThanTheLeastDistance(TriangleMesh mesh)
        {
            List<Vector3> points = Sample(mesh, 3);

            for (int i = 0; i < points.Count; i++)
                for (int j = 0; j < i; j++)
                {
                    Assert.That((points[i] - points[j]).magnitude, Is.GreaterThan(0.829f * Spacing), $"{points[i]} and {points[j]}");
                }
        }

        [TestCaseSource(nameof(Meshes))]
        public void NoneIsOnTheSideOfTheLiquid(TriangleMesh mesh)
        {
            bool looksInward = LiquidMesh.SignedVolume(mesh) < 0.0;
            foreach (Vector3 point in Sample(mesh, 3))
            {
                if (!mesh.IsClosed) Assert.That(point.y, Is.LessThanOrEqualTo(1e-6f), "behind a sheet that faces up");
                else if (!mesh.IsNear(point, 1e-4f * Spacing)) Assert.That(looksInward ? mesh.Winding(point) >= 0 : mesh.Winding(point) > 0,
                    Is.True, $"{point}");
            }
        }

        [Test]
        public void LayersOfABoxAreThoseOfItsLattice()
        {
            List<Vector3> points = Sample(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.5f, 0.7f, 0.9f))), 2);

            Assert.That(points.Count, Is.EqualTo(5 * 7 * 9 - 1 * 3 * 5));
            foreach (Vector3 point in points)
                for (int axis = 0; axis < 3; axis++)
                {
                    Assert.That(Mathf.Repeat(point[axis] / Spacing + 0.25f, 1f), Is.EqualTo(0.25f).Within(1e-3f),
                        "an odd number of sites has one in the middle");
                }
        }

        [Test]
        public void ASphereHasAParticleASpacingSquared()
        {
            const float Radius = 0.8f;
            int count = Sample(TestMeshes.Sphere(Radius, 0.005f)).Count;

            double area = 4.0 * System.Math.PI * (Radius - 0.5 * Spacing) * (Radius - 0.5 * Spacing);
            Assert.That(count * Spacing * Spacing / area, Is.EqualTo(1.0).Within(0.25));
        }

        [Test]
        public void WhatIsThereAlreadyKeepsItsPlace()
        {
            var taken = new SpacedPoints(Spacing);
            var wall = new Vector3(0.05f, -0.05f, 0.05f);
            taken.Add(wall);

            List<Vector3> points =
                Sample(TriangleMesh.Box(Matrix4x4.TRS(new Vector3(0f, -0.1f, 0f), Quaternion.identity, new Vector3(1f, 0.2f, 1f))), 1,
                    taken);

            Assert.That(points.Min(p => (p - wall).magnitude), Is.GreaterThanOrEqualTo(0.83f * Spacing * 0.999f));
        }

        [Test]
        public void ASheetLeavesLiquidBehindItItsPlace()
        {
            var liquid = new SpacedPoints(Spacing);
            var drop = new Vector3(0.02f, -0.1f, 0.02f);
            liquid.Add(drop);

            List<Vector3> free = Sample(TestMeshes.Sheet(), 3), points = Sample(TestMeshes.Sheet(), 3, null, liquid);

            Assert.That(free.Min(p => (p - drop).magnitude), Is.LessThan(0.7f * Spacing));
            Assert.That(points.Where(p => p.y < -0.01f).Min(p => (p - drop).magnitude), Is.GreaterThanOrEqualTo(0.7f * Spacing * 0.999f));
            Assert.That(points.Count(p => p.y > -0.01f), Is.EqualTo(100), "the sheet itself stays whole");
        }

        [Test]
        public void OnlyTheWantedPartIsSampled()
        {
            var corner = new Bounds(new Vector3(50f, 0f, 50f), Vector3.one);
            List<Vector3> points = SurfaceSampler.Sample(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(100f, 0.5f, 100f))), Spacing, 1,
                corner, new SpacedPoints(Spacing));

            Assert.That(points, Is.Not.Empty);
            Assert.That(points.All(corner.Contains), Is.True);
        }

        [Test]
        public void TrianglesWithoutAreaGiveNothing() =>
            Assert.That(Sample(TriangleMesh.FromCorners(new[] { Vector3.zero, Vector3.right, 2f * Vector3.right })), Is.Empty);
    }
}
