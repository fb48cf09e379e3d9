using System.Collections.Generic;
using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh : Object
{
    private readonly VertexStore store;
    private readonly List<SubMeshDescriptor> subMeshes = [new(0, 0)];
    private int[] indices = [];
    private IndexFormat format;
    private bool readable = true;
    private Bounds meshBounds;

    public Mesh() => store = new VertexStore();

    private Mesh(VertexStore store) => this.store = store;

    public bool isReadable => readable;
    public int vertexCount => store.Count;
    public int vertexBufferCount => store.StreamCount;
    public int vertexAttributeCount => store.Attributes.Count;
    public GraphicsBuffer.Target vertexBufferTarget { get; set; } = GraphicsBuffer.Target.Vertex;
    public GraphicsBuffer.Target indexBufferTarget { get; set; } = GraphicsBuffer.Target.Index;

    public Bounds bounds
    {
        get => meshBounds;
        set => meshBounds = value;
    }

    public IndexFormat indexFormat
    {
        get => format;
        set
        {
            format = value;
            Changed();
        }
    }

    public int subMeshCount
    {
        get => subMeshes.Count;
        set
        {
            if (value < 1)
            {
                throw new ArgumentException($"Mesh '{name}' can't have {value} sub-meshes.", nameof(value));
            }

            while (subMeshes.Count > value)
            {
                SubMeshDescriptor last = subMeshes[^1];
                subMeshes.RemoveAt(subMeshes.Count - 1);
                indices = [.. indices[..last.indexStart], .. indices[(last.indexStart + last.indexCount)..]];
            }

            while (subMeshes.Count < value)
            {
                subMeshes.Add(new SubMeshDescriptor(indices.Length, 0));
            }

            Changed();
        }
    }

    internal VertexStore Vertices => store;
    internal IReadOnlyList<SubMeshDescriptor> SubMeshes => subMeshes;
    internal ReadOnlySpan<int> Indices => indices;
    internal MeshDevice Device => deviceField ??= new MeshDevice(this);
    private MeshDevice? deviceField;

    public void Clear() => Clear(true);

    public void Clear(bool keepVertexLayout)
    {
        store.Clear();
        subMeshes.Clear();
        subMeshes.Add(new SubMeshDescriptor(0, 0));
        indices = [];
        meshBounds = default;
        ClearSkin();
        Changed();
    }

    public void MarkDynamic()
    {
    }

    public void MarkModified() => Changed();

    public void Optimize()
    {
    }

    public void OptimizeIndexBuffers()
    {
    }

    public void OptimizeReorderVertexBuffer()
    {
    }

    public void UploadMeshData(bool markNoLongerReadable)
    {
        Device.Upload();
        readable &= !markNoLongerReadable;
    }

    public GraphicsBuffer GetVertexBuffer(int index)
    {
        if ((uint)index >= (uint)store.StreamCount)
        {
            throw new ArgumentOutOfRangeException(nameof(index), $"Mesh '{name}' has {store.StreamCount} vertex buffers; there is none with index {index}.");
        }

        return Device.VertexBufferCopy(index);
    }

    public GraphicsBuffer GetIndexBuffer() => Device.IndexBufferCopy();

    internal void SetReadable(bool value) => readable = value;

    internal override void ReleaseNative() => deviceField?.Dispose();

    internal override Object CloneNative()
    {
        var copy = new Mesh(store.Clone()) { name = name, format = format, indices = [.. indices], meshBounds = meshBounds, readable = readable };
        copy.subMeshes.Clear();
        copy.subMeshes.AddRange(subMeshes);
        copy.CopySkin(this);
        return copy;
    }

    /// <summary>False after an error in the console: content of meshes without Read/Write can't be reached.</summary>
    private bool MayAccess(string what)
    {
        if (!readable)
        {
            Debug.LogError($"Not allowed to access {what} on mesh '{name}' (isReadable is false; Read/Write must be enabled in import settings)");
        }

        return readable;
    }

    private void Changed() => deviceField?.Invalidate();
}
