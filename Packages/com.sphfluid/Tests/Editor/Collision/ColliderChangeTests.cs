using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Triangles are made again when a collider changed, and only then; what cannot be used is named.</summary>
    public sealed class ColliderChangeTests
    {
        private ColliderRig rig;

        [SetUp]
        public void SetUp() => rig = new ColliderRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void NothingChangesNothing()
        {
            rig.Add<BoxCollider>();
            Assert.That(rig.Gather());
            Assert.That(rig.Gather(), Is.False);
            Assert.That(rig.Scene.Colliders.Count, Is.EqualTo(1));
        }

        [Test]
        public void MovesShapesAndArrivalsAreSeen()
        {
            BoxCollider box = rig.Add<BoxCollider>();
            rig.Gather();
            box.transform.position += new Vector3(0.01f, 0f, 0f);
            Assert.That(rig.Gather(), "moved");
            box.size *= 1.1f;
            Assert.That(rig.Gather(), "resized");
            rig.Add<SphereCollider>();
            Assert.That(rig.Gather(), "added");
            box.enabled = false;
            Assert.That(rig.Gather(), "disabled");
            Assert.That(rig.Scene.Colliders.Count, Is.EqualTo(1));
            Assert.That(rig.Gather(), Is.False);
        }

        [Test]
        public void AChangedMeshIsReadAgain()
        {
            Mesh mesh = TestMeshes.Cube();
            rig.AddMesh(mesh);
            Assert.That(ColliderRig.Volume(rig.GatherOne()), Is.EqualTo(1.0).Within(1e-5));
            mesh.vertices = mesh.vertices.Select(v => v * 2f).ToArray();
            mesh.RecalculateBounds();
            Assert.That(rig.Gather());
            Assert.That(ColliderRig.Volume(rig.Scene.Triangles), Is.EqualTo(8.0).Within(1e-4));
        }

        [Test]
        public void InvalidateReadsAnEditThatKeptCountsAndBounds()
        {
            Mesh mesh = TestMeshes.Cube();
            rig.AddMesh(mesh);
            rig.Gather();
            Vector3[] vertices = mesh.vertices;
            vertices[0] *= 0.5f;
            mesh.vertices = vertices;
            mesh.bounds = new Bounds(Vector3.zero, Vector3.one);
            rig.Gather();
            rig.Scene.Invalidate();
            Assert.That(rig.Gather());
            Assert.That(ColliderRig.Volume(rig.Scene.Triangles), Is.LessThan(0.999));
        }

        [Test]
        public void MissingAndEmptyMeshesAreNamedWithTheCure()
        {
            // Without a shape the physics scene holds no such collider; the inspector asks for them directly.
            FluidMessage? missing = ColliderTriangles.Problem(rig.AddMesh(null, "Rock"));
            Assert.That(missing.HasValue);
            Assert.That(missing.Value.Issue, Is.EqualTo(FluidIssue.MeshEmpty));
            Assert.That(missing.Value.ToString(),
                Does.StartWith("[SPH Fluid] 'Rock'").And.Contain("has no mesh").And.Contain("Assign a mesh"));
            FluidMessage? empty = ColliderTriangles.Problem(rig.AddMesh(new Mesh { name = "Void" }, "Hole"));
            Assert.That(empty.HasValue);
            Assert.That(empty.Value.ToString(), Does.StartWith("[SPH Fluid] 'Hole'").And.Contain("'Void'"));
        }

        [Test]
        public void UnreadableMeshIsNamedWithTheCure()
        {
            Mesh mesh = TestMeshes.Cube();
            MeshCollider collider = rig.AddMesh(mesh, "Statue");
            mesh.UploadMeshData(true);
            FluidMessage? problem = ColliderTriangles.Problem(collider);
            Assert.That(problem.HasValue);
            Assert.That(problem.Value.Issue, Is.EqualTo(FluidIssue.MeshNotReadable));
            Assert.That(problem.Value.ToString(),
                Does.StartWith("[SPH Fluid] 'Statue'").And.Contain("'Test Cube'").And.Contain("Read/Write"));
        }

        [Test]
        public void DegenerateTrianglesAreDroppedAndCounted()
        {
            Mesh mesh = TestMeshes.Cube();
            mesh.triangles = mesh.triangles.Concat(new[] { 0, 0, 1, 2, 2, 2 }).ToArray();
            rig.AddMesh(mesh, "Sliver");
            rig.Gather();
            Assert.That(rig.Scene.Triangles.Count, Is.EqualTo(12));
            FluidMessage message = rig.Scene.Messages.Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.DegenerateTriangles));
            Assert.That(message.ToString(), Does.Contain("'Sliver'").And.Contain("2 of 14"));
        }

        [Test]
        public void BufferIsReplacedOnlyWhenItGrows()
        {
            GpuTest.Require();
            BoxCollider box = rig.Add<BoxCollider>();
            rig.Gather();
            rig.Scene.Upload();
            GraphicsBuffer before = rig.Scene.TriangleBuffer;
            box.transform.position += Vector3.right;
            rig.Gather();
            rig.Scene.Upload();
            Assert.That(rig.Scene.TriangleBuffer, Is.SameAs(before));
            CollisionTriangle[] read = GpuTest.Read<CollisionTriangle>(before, 12);
            Assert.That(read.Select(t => t.A), Is.EqualTo(rig.Scene.Triangles.Select(t => t.A)));
            rig.Add<BoxCollider>();
            rig.Gather();
            rig.Scene.Upload();
            Assert.That(rig.Scene.TriangleBuffer.count, Is.EqualTo(24));
        }

        [Test]
        public void CoveringSolidIsFound()
        {
            rig.Add<BoxCollider>("block").transform.position = new Vector3(1f, 0f, 0f);
            rig.Gather();
            int index = rig.Scene.FindCovering(new Vector3(1.2f, 0.1f, 0.1f), 0.03f);
            Assert.That(index, Is.Zero);
            Assert.That(rig.Scene.Solids[index].Name, Is.EqualTo("block"));
            Assert.That(rig.Scene.FindCovering(new Vector3(0.48f, 0f, 0f), 0.03f), Is.Zero, "against the face");
            Assert.That(rig.Scene.FindCovering(new Vector3(0.4f, 0f, 0f), 0.03f), Is.EqualTo(-1));
        }
    }
}
