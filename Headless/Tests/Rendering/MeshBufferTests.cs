using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Meshes whose content a kernel writes.</summary>
public sealed class MeshBufferTests : SceneFixture
{
    private const string Writer = """
        #pragma kernel Write
        RWByteAddressBuffer _Vertices;
        RWByteAddressBuffer _Indices;
        float _Height;
        [numthreads(1, 1, 1)]
        void Write()
        {
            for (uint c = 0; c < 4; c++)
            {
                float3 position = float3((c & 1) * 2.0 - 1, _Height, (c >> 1) * 2.0 - 1);
                _Vertices.Store3(c * 24, asuint(position));
                _Vertices.Store3(c * 24 + 12, asuint(float3(0, 1, 0)));
            }
            _Indices.Store3(0, uint3(0, 2, 1));
            _Indices.Store3(12, uint3(1, 2, 3));

            // What is left is degenerate.
            for (uint i = 6; i < 12; i++) { _Indices.Store(i * 4, 0); }
        }
        """;

    [Test]
    public void AnyMaterialDrawsItWithShadows()
    {
        Camera camera = Camera(new Vector3(0f, 4f, -4f), Vector3.zero);
        Sun(Vector3.down);
        Primitive(PrimitiveType.Plane, Vector3.zero);
        Mesh mesh = MakeMesh();
        var square = new GameObject("Square");
        square.AddComponent<MeshFilter>().sharedMesh = mesh;
        MeshRenderer renderer = square.AddComponent<MeshRenderer>();
        renderer.sharedMaterial = new Material(Shader.Find("Standard")!) { color = Color.red };
        ComputeShader writer = Compute(Writer);
        foreach (float height in (float[])[1f, 0.5f])
        {
            Fill(mesh, writer, height);
            renderer.shadowCastingMode = ShadowCastingMode.On;
            Frame();
            Picture picture = Picture.OfScreen().Keep($"mesh-{height}");
            Color32 middle = picture.At(camera.WorldToScreenPoint(new Vector3(0.9f, height, 0.9f)));
            Assert.That(middle.r > middle.g * 2, Is.True, $"the square at {height}");
            renderer.shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            Frame();
            picture = Picture.OfScreen();
            Assert.That(
                picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.5f, 0f, 0.5f))) * 1.4f,
                Is.LessThan(picture.Brightness(camera.WorldToScreenPoint(new Vector3(1.6f, 0f, 0f)))), "its shadow");
        }
    }

    [Test]
    public void WhatAKernelWroteStaysWhenBoundsChange()
    {
        Mesh mesh = MakeMesh();
        Fill(mesh, Compute(Writer), 3f);
        mesh.bounds = new Bounds(Vector3.zero, Vector3.one);
        using GraphicsBuffer vertices = mesh.GetVertexBuffer(0);
        Assert.That((vertices.count, vertices.stride), Is.EqualTo((4, 24)));
        Assert.That((vertices.target & GraphicsBuffer.Target.Raw) != 0, Is.True);
        Assert.That(Read(vertices)[1], Is.EqualTo(3f));

        // A disposed handle leaves the mesh's own buffer alone.
        vertices.Dispose();
        using GraphicsBuffer again = mesh.GetVertexBuffer(0);
        Assert.That(Read(again)[1], Is.EqualTo(3f));
    }

    private static Mesh MakeMesh()
    {
        var mesh = new Mesh { name = "Written", indexFormat = IndexFormat.UInt32 };
        mesh.vertexBufferTarget |= GraphicsBuffer.Target.Raw;
        mesh.indexBufferTarget |= GraphicsBuffer.Target.Raw;
        mesh.SetVertexBufferParams(
            4, new VertexAttributeDescriptor(VertexAttribute.Position), new VertexAttributeDescriptor(VertexAttribute.Normal));
        mesh.SetIndexBufferParams(12, IndexFormat.UInt32);
        mesh.SetSubMesh(0, new SubMeshDescriptor(0, 12), MeshUpdateFlags.DontRecalculateBounds | MeshUpdateFlags.DontValidateIndices);
        mesh.bounds = new Bounds(Vector3.zero, Vector3.one * 4f);
        return mesh;
    }

    private static void Fill(Mesh mesh, ComputeShader writer, float height)
    {
        using GraphicsBuffer vertices = mesh.GetVertexBuffer(0);
        using GraphicsBuffer indices = mesh.GetIndexBuffer();
        using var commands = new CommandBuffer();
        commands.SetComputeFloatParam(writer, "_Height", height);
        commands.SetComputeBufferParam(writer, 0, "_Vertices", vertices);
        commands.SetComputeBufferParam(writer, 0, "_Indices", indices);
        commands.DispatchCompute(writer, 0, 1, 1, 1);
        Graphics.ExecuteCommandBuffer(commands);
    }
}
