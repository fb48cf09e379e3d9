using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Closedness, degenerate triangles and mirroring.</summary>
    public sealed class TriangleMeshTests
    {
        [Test]
        public void SeamsOfSplitVerticesAreClosed() => Assert.That(new MeshReader().Read(TestMeshes.Cube()).IsClosed);

        [Test]
        public void SheetsAndFlippedTrianglesAreOpen()
        {
            Assert.That(TestMeshes.Sheet().IsClosed, Is.False);
            TriangleMesh box = PrimitiveTessellator.Box(Matrix4x4.identity);
            var flipped = (int[])box.Indices.Clone();
            (flipped[0], flipped[1]) = (flipped[1], flipped[0]);
            Assert.That(new TriangleMesh(box.Vertices, flipped).IsClosed, Is.False);
            Assert.That(new TriangleMesh(new Vector3[0], new int[0]).IsClosed, Is.False);
        }

        [Test]
        public void MirroringKeepsOutwardOutward()
        {
            TriangleMesh mirrored = PrimitiveTessellator.Box(Matrix4x4.identity).Transformed(Matrix4x4.Scale(new Vector3(-1f, 1f, 1f)));
            Assert.That(TestMeshes.Volume(mirrored), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(mirrored.IsClosed);
        }

        [Test]
        public void ACopyThatIsFlatAsksFirstAndChangesNothing()
        {
            TriangleMesh box = new MeshReader().Read(TestMeshes.Cube());
            TriangleMesh flat = box.Transformed(Matrix4x4.Scale(new Vector3(1f, 0f, 1f)));
            Assert.That(flat.Winding(Vector3.one), Is.Zero);
            Assert.That(box.IsClosed);
            Assert.That(box.Contains(box.Bounds.center));
            Assert.That(box.Transformed(Matrix4x4.Translate(Vector3.up)).Contains(box.Bounds.center + Vector3.up));
        }

        [Test]
        public void DegenerateTrianglesAreFound()
        {
            Vector3 x = Vector3.right, y = Vector3.up;
            Assert.That(TriangleMesh.IsDegenerate(x, x, y));
            Assert.That(TriangleMesh.IsDegenerate(Vector3.zero, x, 2f * x));
            Assert.That(TriangleMesh.IsDegenerate(Vector3.zero, x, new Vector3(0f, float.NaN, 0f)));
            Assert.That(TriangleMesh.IsDegenerate(Vector3.zero, Vector3.zero, Vector3.zero));
            Assert.That(TriangleMesh.IsDegenerate(Vector3.zero, 1e-4f * x, 1e-4f * y), Is.False, "small is not degenerate");
            Assert.That(TriangleMesh.IsDegenerate(Vector3.zero, x, x + 1e-3f * y), Is.False, "thin is not degenerate");
        }

        [Test]
        public void IndicesComeInThrees() => Assert.That(() => new TriangleMesh(new Vector3[4], new int[4]), Throws.ArgumentException);

        [Test]
        public void AffineInverseAndSingularTransforms()
        {
            Matrix4x4 m = Matrix4x4.TRS(new Vector3(3f, -2f, 1f), Quaternion.Euler(15f, 80f, -30f), new Vector3(2f, -0.5f, 1e-3f));
            Assert.That(AffineMath.TryInvert(m, out Matrix4x4 inverse));
            Vector3 back = inverse.MultiplyPoint3x4(m.MultiplyPoint3x4(new Vector3(0.3f, 0.4f, 0.5f)));
            Assert.That((back - new Vector3(0.3f, 0.4f, 0.5f)).magnitude, Is.LessThan(1e-3f));
            Assert.That(AffineMath.IsSingular(Matrix4x4.Scale(new Vector3(1f, 0f, 1f))));
            Assert.That(AffineMath.IsSingular(Matrix4x4.Scale(new Vector3(1f, float.NaN, 1f))));
            Assert.That(AffineMath.IsSingular(Matrix4x4.Scale(new Vector3(1e-4f, 1e-4f, 1e-4f))), Is.False, "small is not flat");
        }
    }
}
