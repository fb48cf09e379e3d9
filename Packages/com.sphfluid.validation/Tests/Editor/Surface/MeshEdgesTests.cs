using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Edges and parts of meshes that are known.</summary>
    public sealed class MeshEdgesTests
    {
        [Test]
        public void ATetrahedronIsClosed()
        {
            MeshEdges edges = MeshEdges.Of(ExactMeshes.Tetrahedron());

            Assert.That((edges.Vertices, edges.Count, edges.Triangles, edges.Euler), Is.EqualTo((4, 6, 4, 2)));
            Assert.That(edges.IsClosed, Is.True);
        }

        [Test]
        public void ATorusHasTheEulerCharacteristicZero()
        {
            MeshEdges edges = MeshEdges.Of(ExactMeshes.Torus(3f, 1f, 12));

            Assert.That(edges.IsClosed, Is.True);
            Assert.That(edges.Euler, Is.Zero);
        }

        [Test]
        public void AMissingTriangleOpensThreeEdges()
        {
            SurfaceMesh whole = ExactMeshes.Tetrahedron();
            MeshEdges edges = MeshEdges.Of(ExactMeshes.With(whole, whole.Indices.Skip(3)));

            Assert.That((edges.OpenEdges, edges.NonManifoldEdges, edges.FlippedEdges), Is.EqualTo((3, 0, 0)));
        }

        [Test]
        public void ATurnedTriangleFlipsThreeEdges()
        {
            SurfaceMesh whole = ExactMeshes.Tetrahedron();
            int[] indices = whole.Indices.ToArray();
            (indices[0], indices[1]) = (indices[1], indices[0]);
            MeshEdges edges = MeshEdges.Of(ExactMeshes.With(whole, indices));

            Assert.That((edges.OpenEdges, edges.NonManifoldEdges, edges.FlippedEdges), Is.EqualTo((0, 0, 3)));
        }

        [Test]
        public void AFinIsNotManifold()
        {
            SurfaceMesh box = ExactMeshes.Box(Vector3.zero, Vector3.one);
            MeshEdges edges = MeshEdges.Of(ExactMeshes.With(box, box.Indices.Concat(new[] { 0, 4, 7 })));

            Assert.That((edges.OpenEdges, edges.NonManifoldEdges), Is.EqualTo((1, 2)),
                "0-4 and the diagonal of the face 4, 6, 7, 5 are in use; 0-7 is new");
        }

        [Test]
        public void AnEmptyMeshIsClosed() =>
            Assert.That(MeshEdges.Of(ExactMeshes.With(ExactMeshes.Tetrahedron(), new int[0])).IsClosed, Is.True);

        [Test]
        public void TellsPartsAndTheirVolumes()
        {
            var parts =
                new MeshComponents(ExactMeshes.Both(ExactMeshes.Box(Vector3.zero, Vector3.one),
                    ExactMeshes.Box(3f * Vector3.one, 5f * Vector3.one)));

            Assert.That(parts.Count, Is.EqualTo(2));
            int small = parts.Near(new Vector3(1.1f, 1.1f, 1.1f), 0.5f), large = parts.Near(new Vector3(5.2f, 5f, 5f), 0.5f);
            Assert.That(parts.Volume(small), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(parts.Volume(large), Is.EqualTo(8.0).Within(1e-5));
            Assert.That(parts.Near(2f * Vector3.one, 0.5f), Is.EqualTo(-1));
        }
    }
}
