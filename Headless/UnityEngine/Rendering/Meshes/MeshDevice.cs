using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The GPU buffers of a mesh, made when it is first drawn and again after changes.</summary>
internal sealed class MeshDevice(Mesh mesh) : IDisposable
{
    private DeviceBuffer[] vertexBuffers = [];
    private DeviceBuffer? indexBuffer;
    private (int Start, int Count)[] ranges = [];
    private bool valid;

    public IReadOnlyList<DeviceBuffer> VertexBuffers => vertexBuffers;
    public DeviceBuffer? IndexBuffer => indexBuffer;
    public bool Indices32 { get; private set; }

    /// <summary>Indices of a sub-mesh in the GPU's buffer, where quads are stored as triangles.</summary>
    public (int Start, int Count) Range(int subMesh) => ranges[subMesh];

    public void Invalidate() => valid = false;

    public void Upload()
    {
        if (valid)
        {
            return;
        }

        valid = true;
        UploadVertices();
        UploadIndices();
    }

    public GraphicsBuffer VertexBufferCopy(int stream)
    {
        Upload();
        return new GraphicsBuffer(mesh.vertexBufferTarget, vertexBuffers[stream]);
    }

    public GraphicsBuffer IndexBufferCopy()
    {
        Upload();
        return new GraphicsBuffer(
            mesh.indexBufferTarget, indexBuffer ?? throw new InvalidOperationException($"Mesh '{mesh.name}' has no indices."));
    }

    public void Dispose()
    {
        foreach (DeviceBuffer buffer in vertexBuffers)
        {
            buffer.Release();
        }

        indexBuffer?.Release();
        (vertexBuffers, indexBuffer, valid) = ([], null, false);
    }

    private void UploadVertices()
    {
        VertexStore store = mesh.Vertices;
        bool fits = vertexBuffers.Length == store.StreamCount;
        for (int i = 0; fits && i < vertexBuffers.Length; i++)
        {
            fits = vertexBuffers[i].Count == store.Count && vertexBuffers[i].Stride == store.Stride(i);
        }

        if (!fits)
        {
            foreach (DeviceBuffer buffer in vertexBuffers)
            {
                buffer.Release();
            }

            vertexBuffers = store.Count == 0 ? [] : new DeviceBuffer[store.StreamCount];
            for (int i = 0; i < vertexBuffers.Length; i++)
            {
                vertexBuffers[i] = new DeviceBuffer("Mesh vertex buffer", store.Count, store.Stride(i), BufferUse.Vertex | BufferUse.Storage)
                {
                    Name = mesh.name,
                };
            }
        }

        for (int i = 0; i < vertexBuffers.Length; i++)
        {
            GraphicsDevice.Recorder.UpdateBuffer(vertexBuffers[i].Gpu, 0, store.Stream(i));
        }
    }

    private void UploadIndices()
    {
        int[] values = Expand();
        Indices32 = mesh.indexFormat == IndexFormat.UInt32;
        int stride = Indices32 ? 4 : 2;
        if (indexBuffer is not null && (indexBuffer.Count != values.Length || indexBuffer.Stride != stride))
        {
            indexBuffer.Release();
            indexBuffer = null;
        }

        if (values.Length == 0)
        {
            return;
        }

        indexBuffer ??= new DeviceBuffer("Mesh index buffer", values.Length, stride, BufferUse.Index | BufferUse.Storage) { Name = mesh.name };
        if (Indices32)
        {
            GraphicsDevice.Recorder.UpdateBuffer(indexBuffer.Gpu, 0, MemoryMarshal.AsBytes(values.AsSpan()));
        }
        else
        {
            // Padded to whole words.
            var shorts = new ushort[(values.Length + 1) & ~1];
            for (int i = 0; i < values.Length; i++)
            {
                shorts[i] = (ushort)values[i];
            }

            GraphicsDevice.Recorder.UpdateBuffer(indexBuffer.Gpu, 0, MemoryMarshal.AsBytes(shorts.AsSpan()));
        }
    }

    private int[] Expand()
    {
        ranges = new (int, int)[mesh.SubMeshes.Count];
        bool quads = mesh.SubMeshes.Any(s => s.topology == MeshTopology.Quads);
        if (!quads)
        {
            for (int i = 0; i < ranges.Length; i++)
            {
                ranges[i] = (mesh.SubMeshes[i].indexStart, mesh.SubMeshes[i].indexCount);
            }

            return mesh.Indices.ToArray();
        }

        var all = new List<int>();
        for (int i = 0; i < ranges.Length; i++)
        {
            SubMeshDescriptor part = mesh.SubMeshes[i];
            ReadOnlySpan<int> source = mesh.Indices.Slice(part.indexStart, part.indexCount);
            int start = all.Count;
            if (part.topology != MeshTopology.Quads)
            {
                all.AddRange(source);
            }
            else
            {
                for (int q = 0; q + 3 < source.Length; q += 4)
                {
                    all.AddRange([source[q], source[q + 1], source[q + 2], source[q], source[q + 2], source[q + 3]]);
                }
            }

            ranges[i] = (start, all.Count - start);
        }

        return [.. all];
    }
}
