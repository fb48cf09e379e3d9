using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class MeshTests : RenderFixture
{
    [TestCase(PrimitiveType.Cube, 24, 1f, 1f, 1f)]
    [TestCase(PrimitiveType.Sphere, 0, 1f, 1f, 1f)]
    [TestCase(PrimitiveType.Capsule, 0, 1f, 2f, 1f)]
    [TestCase(PrimitiveType.Cylinder, 0, 1f, 2f, 1f)]
    [TestCase(PrimitiveType.Plane, 121, 10f, 0f, 10f)]
    [TestCase(PrimitiveType.Quad, 4, 1f, 1f, 0f)]
    public void PrimitivesHaveUnitysSizesAndFaceOutwards(PrimitiveType type, int vertexCount, float x, float y, float z)
    {
        Mesh mesh = GameObject.CreatePrimitive(type).GetComponent<MeshFilter>().sharedMesh!;
        Assert.That(mesh.bounds.size.x, Is.EqualTo(x).Within(1e-4f));
        Assert.That(mesh.bounds.size.y, Is.EqualTo(y).Within(1e-4f));
        Assert.That(mesh.bounds.size.z, Is.EqualTo(z).Within(1e-4f));
        if (vertexCount > 0)
        {
            Assert.That(mesh.vertexCount, Is.EqualTo(vertexCount));
        }

        Vector3[] vertices = mesh.vertices;
        Vector3[] normals = mesh.normals;
        int[] triangles = mesh.triangles;
        for (int i = 0; i < triangles.Length; i += 3)
        {
            (Vector3 a, Vector3 b, Vector3 c) = (vertices[triangles[i]], vertices[triangles[i + 1]], vertices[triangles[i + 2]]);
            Vector3 face = Vector3.Cross(b - a, c - a);
            if (face.sqrMagnitude > 1e-12f)
            {
                Assert.That(Vector3.Dot(face, normals[triangles[i]] + normals[triangles[i + 1]] + normals[triangles[i + 2]]), Is.GreaterThan(0f), $"triangle {i / 3}");
            }
        }
    }

    [Test]
    public void AttributesKeepTheirValues()
    {
        var mesh = new Mesh { vertices = [Vector3.zero, Vector3.right, Vector3.up], triangles = [0, 2, 1] };
        mesh.uv = [new Vector2(0, 0), new Vector2(1, 0), new Vector2(0, 1)];
        mesh.SetUVs(2, new List<Vector4> { new(1, 2, 3, 4), new(5, 6, 7, 8), new(9, 10, 11, 12) });
        mesh.colors32 = [new Color32(1, 2, 3, 4), new Color32(5, 6, 7, 8), new Color32(9, 10, 11, 12)];
        mesh.RecalculateNormals();
        mesh.RecalculateTangents();
        Assert.That(mesh.normals, Is.All.EqualTo(Vector3.back));
        Assert.That(mesh.uv[2], Is.EqualTo(new Vector2(0, 1)));
        Assert.That(mesh.colors32[1], Is.EqualTo(new Color32(5, 6, 7, 8)));
        var third = new List<Vector4>();
        mesh.GetUVs(2, third);
        Assert.That(third[1], Is.EqualTo(new Vector4(5, 6, 7, 8)));
        Assert.That(mesh.bounds.max, Is.EqualTo(new Vector3(1, 1, 0)));
    }

    [Test]
    public void SubMeshesKeepApart()
    {
        var mesh = new Mesh { vertices = new Vector3[8], subMeshCount = 2 };
        mesh.SetTriangles(new[] { 0, 1, 2, 2, 3, 0 }, 0);
        mesh.SetIndices(new[] { 4, 5, 6, 7 }, MeshTopology.Quads, 1);
        mesh.SetTriangles(new[] { 0, 1, 2 }, 0);
        Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 0, 1, 2 }));
        Assert.That(mesh.GetIndices(1), Is.EqualTo(new[] { 4, 5, 6, 7 }));
        Assert.That(mesh.GetTopology(1), Is.EqualTo(MeshTopology.Quads));
        Assert.That(mesh.triangles, Is.EqualTo(new[] { 0, 1, 2 }));
    }

    [Test]
    public void BadIndicesAndLengthsAreErrors()
    {
        var mesh = new Mesh { name = "Bad", vertices = new Vector3[3] };
        mesh.triangles = [0, 1, 3];
        mesh.normals = new Vector3[2];
        string[] errors = TakeErrors();
        Assert.That(errors, Has.Length.EqualTo(2));
        Assert.That(errors, Has.All.Contains("Bad"));
    }

    [Test]
    public void WithoutReadWriteTheContentIsOutOfReach()
    {
        var mesh = new Mesh { name = "Closed", vertices = new Vector3[3], triangles = [0, 1, 2] };
        mesh.UploadMeshData(true);
        Assert.That(mesh.isReadable, Is.False);
        Assert.That(mesh.vertices, Is.Empty);
        Assert.That(TakeErrors(), Has.Some.Contains("Closed").And.Some.Contains("isReadable"));
    }

    [Test]
    public void VertexBuffersAreReadableByKernels()
    {
        var mesh = new Mesh { vertices = [Vector3.zero, Vector3.right, new Vector3(1, 2, 3)], triangles = [0, 1, 2] };
        mesh.vertexBufferTarget |= GraphicsBuffer.Target.Raw;
        using GraphicsBuffer vertices = mesh.GetVertexBuffer(0);
        Assert.That((vertices.count, vertices.stride), Is.EqualTo((3, 12)));
        Assert.That(Read(vertices)[8], Is.EqualTo(3f));
    }

    [Test]
    public void LargeMeshesNeedWideIndices()
    {
        var mesh = new Mesh { vertices = new Vector3[70000] };
        mesh.triangles = [0, 1, 69999];
        Assert.That(TakeErrors(), Has.Some.Contains("UInt32"));
        mesh.indexFormat = IndexFormat.UInt32;
        mesh.triangles = [0, 1, 69999];
        Assert.That(mesh.triangles[2], Is.EqualTo(69999));
    }
}
