using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Which triangles hang together, which way they run, and which of their edges lie within a plane.</summary>
    public sealed class MeshSurfacesTests
    {
        // Corners split at the seams, as importers leave them.
        private static List<Vector3> Split(TriangleMesh mesh) => mesh.Indices.Select(i => mesh.Vertices[i]).ToList();

        private static TriangleMesh Box(Vector3 at) => TriangleMesh.Box(Matrix4x4.Translate(at));

        private static MeshSurfaces Of(List<Vector3> corners) => TriangleMesh.FromCorners(corners).Surfaces;

        private static int InPlane(MeshSurfaces found) => found.Edges.Sum(e => (int)((e & 1u) + (e >> 1 & 1u) + (e >> 2 & 1u)));

        [Test]
        public void ABoxIsOneSurfaceAndEachOfItsFacesHasADiagonal()
        {
            MeshSurfaces found = Of(Split(Box(Vector3.zero)));
            Assert.That(found.Count, Is.EqualTo(1));
            Assert.That(InPlane(found), Is.EqualTo(12));
            Assert.That(found.Edges.Count(e => (e & MeshSurfaces.Turned) != 0u), Is.Zero);
            Assert.That(found.Order.OrderBy(t => t), Is.EqualTo(Enumerable.Range(0, 12)));
        }

        // Some triangles run the other way round: the same surface, in which these are turned, or all the others.
        [Test]
        public void TrianglesThatRunTheOtherWayAreTurned([Values(0, 1, 5, 11)] int turned)
        {
            List<Vector3> corners = Split(Box(Vector3.zero));
            (corners[3 * turned + 1], corners[3 * turned + 2]) = (corners[3 * turned + 2], corners[3 * turned + 1]);
            MeshSurfaces found = Of(corners);
            Assert.That(found.Count, Is.EqualTo(1));
            Assert.That(InPlane(found), Is.EqualTo(12));
            bool first = (found.Edges[turned] & MeshSurfaces.Turned) != 0u;
            Assert.That(Enumerable.Range(0, 12).Count(t => (found.Edges[t] & MeshSurfaces.Turned) != 0u == first), Is.EqualTo(1),
                "that one alone");
        }

        [Test]
        public void ShapesApartAreSurfacesOfTheirOwnSideBySideInTheOrder()
        {
            List<Vector3> one = Split(Box(Vector3.zero)), other = Split(Box(3f * Vector3.right)), mixed = new List<Vector3>();
            for (int t = 0; t < 12; t++) mixed.AddRange(one.Skip(3 * t).Take(3).Concat(other.Skip(3 * t).Take(3)));
            MeshSurfaces found = Of(mixed);
            Assert.That(found.Count, Is.EqualTo(2));
            uint[] numbers = found.Order.Select(t => found.Edges[t] >> MeshSurfaces.NumberShift).ToArray();
            Assert.That(numbers, Is.Ordered);
            for (int t = 0; t < 24; t++)
            {
                Assert.That(found.Edges[t] >> MeshSurfaces.NumberShift, Is.EqualTo(found.Edges[t % 2] >> MeshSurfaces.NumberShift));
            }
        }

        // Of its size of 1.7.
        [TestCase(1e-6f, 1)]
        [TestCase(1e-4f, 2)]
        public void CornersWithinAMillionthOfTheSizeAreOne(float apart, int surfaces)
        {
            var low = new Vector3(0.5f, 0.3f, 0f);
            var corners = new List<Vector3> { Vector3.zero, Vector3.right, low, Vector3.zero, low + apart * Vector3.forward, Vector3.up };
            Assert.That(Of(corners).Count, Is.EqualTo(surfaces));
        }

        // Nearness is to the first of a place, and is not handed on.
        [Test]
        public void ARowOfCornersIsNotDrawnTogether() =>
            Assert.That(new VertexWeld(new[] { 0f, 0.8f, 1.6f, 2.2f }.Select(x => x * Vector3.right).ToArray(), 1f).Numbers,
                Is.EqualTo(new[] { 0, 0, 2, 2 }));

        [Test]
        public void AtAnEdgeOfThreeSurfacesNoneGoesOn()
        {
            Vector3 a = Vector3.zero, b = Vector3.right;
            var corners = new List<Vector3> { a, b, Vector3.up, a, b, Vector3.forward, a, b, Vector3.down };
            MeshSurfaces found = Of(corners);
            Assert.That(found.Count, Is.EqualTo(3));
            Assert.That(InPlane(found), Is.Zero);
        }

        [Test]
        public void WhereCornersMoveNoTwoTrianglesStayInAPlane()
        {
            MeshSurfaces found = Of(Split(Box(Vector3.zero)));
            Assert.That(InPlane(found.Deforming), Is.Zero);
            Assert.That(found.Deforming.Count, Is.EqualTo(1));
            Assert.That(found.Deforming, Is.SameAs(found.Deforming));
            Assert.That(found.Deforming.Deforming, Is.SameAs(found.Deforming), "nothing is made anew frame by frame");
        }

        [Test]
        public void WithoutTrianglesThereIsNone() => Assert.That(Of(new List<Vector3>()).Count, Is.Zero);
    }
}
