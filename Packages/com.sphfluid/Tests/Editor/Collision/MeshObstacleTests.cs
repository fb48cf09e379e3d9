using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Points inside closed meshes and near any mesh are found, also where rays go through edges and vertices.</summary>
    public sealed class MeshObstacleTests
    {
        [Test]
        public void BoxOnALatticeIsExact()
        {
            // Points in the planes of the faces' diagonals and of the vertices: the hard cases of a ray test.
            var box = new MeshObstacle(PrimitiveTessellator.Box(Matrix4x4.identity));
            for (int x = -8; x <= 8; x++)
                for (int y = -8; y <= 8; y++)
                    for (int z = -8; z <= 8; z++)
                    {
                        if (Mathf.Abs(x) == 4 || Mathf.Abs(y) == 4 || Mathf.Abs(z) == 4) continue; // on a face: either answer
                        bool inside = Mathf.Abs(x) < 4 && Mathf.Abs(y) < 4 && Mathf.Abs(z) < 4;
                        Assert.That(box.Contains(new Vector3(x, y, z) / 8f), Is.EqualTo(inside), $"{x} {y} {z}");
                    }
        }

        [Test]
        public void SphereHoldsItsVolume()
        {
            TriangleMesh mesh = TestMeshes.Sphere(0.5f, 0.002f).Transformed(Matrix4x4.Rotate(Quaternion.Euler(20f, 30f, 40f)));
            var sphere = new MeshObstacle(mesh);
            int inside = 0, wrong = 0;
            for (int x = 0; x < 40; x++)
                for (int y = 0; y < 40; y++)
                    for (int z = 0; z < 40; z++)
                    {
                        Vector3 p = new Vector3(x - 19.5f, y - 19.5f, z - 19.5f) * (1.2f / 40f);
                        bool contained = sphere.Contains(p);
                        if (contained) inside++;
                        if (Mathf.Abs(p.magnitude - 0.5f) > 0.003f && contained != p.magnitude < 0.5f) wrong++;
                    }
            Assert.That(wrong, Is.Zero);
            Assert.That(inside * System.Math.Pow(1.2 / 40, 3), Is.EqualTo(TestMeshes.Volume(mesh)).Within(1).Percent);
        }

        [Test]
        public void InwardFacesHoldNoSolidAndHollowShellHoldsOnlyItsWall()
        {
            TriangleMesh hollow = Flipped(PrimitiveTessellator.Box(Matrix4x4.identity));
            Assert.That(hollow.IsClosed);
            Assert.That(new MeshObstacle(hollow).Contains(Vector3.zero), Is.False);

            var shell = new MeshObstacle(Joined(PrimitiveTessellator.Box(Matrix4x4.Scale(new Vector3(2f, 2f, 2f))), hollow));
            Assert.That(shell.Contains(Vector3.zero), Is.False);
            Assert.That(shell.Contains(new Vector3(0.75f, 0f, 0f)));
        }

        [Test]
        public void OverlappingShellsAreOneSolid()
        {
            TriangleMesh box = PrimitiveTessellator.Box(Matrix4x4.identity);
            var two = new MeshObstacle(Joined(box, box.Transformed(Matrix4x4.Translate(new Vector3(0.5f, 0f, 0f)))));
            Assert.That(two.Contains(new Vector3(0.25f, 0.1f, 0.1f)));
            Assert.That(two.Contains(new Vector3(0.8f, 0.1f, 0.1f)));
            Assert.That(two.Contains(new Vector3(1.1f, 0.1f, 0.1f)), Is.False);
        }

        [Test]
        public void OpenSheetCoversOnlyWhatIsNear()
        {
            var sheet = new MeshObstacle(TestMeshes.Sheet());
            Assert.That(sheet.Contains(new Vector3(0f, -0.01f, 0f)), Is.False);
            Assert.That(sheet.Covers(new Vector3(0.1f, 0.04f, 0.2f), 0.05f));
            Assert.That(sheet.Covers(new Vector3(0.1f, -0.04f, 0.2f), 0.05f));
            Assert.That(sheet.Covers(new Vector3(0.1f, 0.06f, 0.2f), 0.05f), Is.False);
            Assert.That(sheet.Covers(new Vector3(0.54f, 0f, 0f), 0.05f), "beyond the edge");
            Assert.That(sheet.Covers(new Vector3(0.1f, 0f, 0.2f), 0f), Is.False, "no clearance, no cover");
        }

        [TestCase(2f, 0f, 0f, 1f, 0f, 0f)]
        [TestCase(0.2f, 0.2f, 5f, 0.2f, 0.2f, 0f)]
        [TestCase(-1f, -1f, 3f, 0f, 0f, 0f)]
        [TestCase(1f, 1f, 0f, 0.5f, 0.5f, 0f)]
        [TestCase(-1f, 0.5f, 0f, 0f, 0.5f, 0f)]
        [TestCase(0f, 3f, 0f, 0f, 1f, 0f)]
        public void ClosestPointInEachRegion(float x, float y, float z, float cx, float cy, float cz)
        {
            Vector3 closest = TriangleMath.ClosestPoint(new Vector3(x, y, z), Vector3.zero, Vector3.right, Vector3.up);
            Assert.That((closest - new Vector3(cx, cy, cz)).magnitude, Is.LessThan(1e-6f));
        }

        private static TriangleMesh Flipped(TriangleMesh mesh)
        {
            var indices = (int[])mesh.Indices.Clone();
            System.Array.Reverse(indices);
            return new TriangleMesh(mesh.Vertices, indices);
        }

        private static TriangleMesh Joined(TriangleMesh a, TriangleMesh b)
        {
            var vertices = new Vector3[a.Vertices.Length + b.Vertices.Length];
            a.Vertices.CopyTo(vertices, 0);
            b.Vertices.CopyTo(vertices, a.Vertices.Length);
            var indices = new int[a.Indices.Length + b.Indices.Length];
            a.Indices.CopyTo(indices, 0);
            for (int i = 0; i < b.Indices.Length; i++) indices[a.Indices.Length + i] = b.Indices[i] + a.Vertices.Length;
            return new TriangleMesh(vertices, indices);
        }
    }
}
