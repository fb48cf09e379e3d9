using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public bool HasVertexAttribute(VertexAttribute attr) => store.Has(attr);

    public int GetVertexAttributeDimension(VertexAttribute attr) => store.Find(attr) is >= 0 and int i ? store.Attributes[i].dimension : 0;

    public VertexAttributeFormat GetVertexAttributeFormat(VertexAttribute attr) =>
        store.Find(attr) is >= 0 and int i ? store.Attributes[i].format : default;

    public int GetVertexAttributeOffset(VertexAttribute attr) => store.Offset(attr);

    public int GetVertexAttributeStream(VertexAttribute attr) => store.Find(attr) is >= 0 and int i ? store.Attributes[i].stream : -1;

    public VertexAttributeDescriptor GetVertexAttribute(int index) => store.Attributes[index];

    public VertexAttributeDescriptor[] GetVertexAttributes() => [.. store.Attributes];

    public int GetVertexBufferStride(int stream) => store.Stride(stream);

    public void SetVertexBufferParams(int vertexCount, params VertexAttributeDescriptor[] attributes)
    {
        store.SetLayout(vertexCount, attributes.Length == 0 ? [new VertexAttributeDescriptor()] : attributes, true);
        Changed();
    }

    public void SetVertexBufferParams(int vertexCount, NativeArray<VertexAttributeDescriptor> attributes) =>
        SetVertexBufferParams(vertexCount, NativeSpans.Read(attributes).ToArray());

    public void SetVertexBufferData<T>(T[] data, int dataStart, int meshBufferStart, int count, int stream = 0, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetVertexBytes(data.AsSpan(dataStart, count), meshBufferStart, stream);

    public void SetVertexBufferData<T>(List<T> data, int dataStart, int meshBufferStart, int count, int stream = 0, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetVertexBytes<T>(CollectionsMarshal.AsSpan(data).Slice(dataStart, count), meshBufferStart, stream);

    public void SetVertexBufferData<T>(NativeArray<T> data, int dataStart, int meshBufferStart, int count, int stream = 0, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetVertexBytes(NativeSpans.Read(data).Slice(dataStart, count), meshBufferStart, stream);

    public void SetIndexBufferParams(int indexCount, IndexFormat format)
    {
        this.format = format;
        Array.Resize(ref indices, indexCount);
        Changed();
    }

    public void SetIndexBufferData<T>(T[] data, int dataStart, int meshBufferStart, int count, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetIndexValues<T>(data.AsSpan(dataStart, count), meshBufferStart);

    public void SetIndexBufferData<T>(List<T> data, int dataStart, int meshBufferStart, int count, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetIndexValues<T>(CollectionsMarshal.AsSpan(data).Slice(dataStart, count), meshBufferStart);

    public void SetIndexBufferData<T>(NativeArray<T> data, int dataStart, int meshBufferStart, int count, MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct => SetIndexValues(NativeSpans.Read(data).Slice(dataStart, count), meshBufferStart);

    public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
    {
        RequireSubMesh(index);
        if (desc.indexStart < 0 || desc.indexCount < 0 || desc.indexStart + desc.indexCount > indices.Length)
        {
            throw new ArgumentException($"Sub-mesh {index} of mesh '{name}' wants indices {desc.indexStart} to {desc.indexStart + desc.indexCount} of {indices.Length}.");
        }

        subMeshes[index] = desc;
        if ((flags & MeshUpdateFlags.DontRecalculateBounds) == 0)
        {
            RecalculateBounds();
        }

        Changed();
    }

    public void SetSubMeshes(SubMeshDescriptor[] desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
    {
        subMeshCount = desc.Length;
        for (int i = 0; i < desc.Length; i++)
        {
            SetSubMesh(i, desc[i], flags);
        }
    }

    private void SetVertexBytes<T>(ReadOnlySpan<T> data, int start, int stream)
        where T : struct
    {
        if ((uint)stream >= (uint)store.StreamCount)
        {
            throw new ArgumentOutOfRangeException(nameof(stream), $"Mesh '{name}' has {store.StreamCount} vertex streams; there is none with index {stream}.");
        }

        ReadOnlySpan<byte> bytes = NativeSpans.BytesOf(data);
        int offset = start * NativeSpans.SizeOf<T>();
        byte[] target = store.Stream(stream);
        if (offset + bytes.Length > target.Length)
        {
            throw new ArgumentException($"{bytes.Length} bytes at {offset} exceed the {target.Length} bytes of vertex stream {stream} of mesh '{name}'.");
        }

        bytes.CopyTo(target.AsSpan(offset));
        Changed();
    }

    private void SetIndexValues<T>(ReadOnlySpan<T> data, int start)
        where T : struct
    {
        ReadOnlySpan<byte> bytes = NativeSpans.BytesOf(data);
        int size = format == IndexFormat.UInt16 ? 2 : 4;
        int count = bytes.Length / size;
        int first = start * NativeSpans.SizeOf<T>() / size;
        if (first + count > indices.Length)
        {
            throw new ArgumentException($"{count} indices at {first} exceed the {indices.Length} indices of mesh '{name}'.");
        }

        for (int i = 0; i < count; i++)
        {
            indices[first + i] = size == 2
                ? MemoryMarshal.Read<ushort>(bytes[(i * 2)..])
                : MemoryMarshal.Read<int>(bytes[(i * 4)..]);
        }

        Changed();
    }
}
