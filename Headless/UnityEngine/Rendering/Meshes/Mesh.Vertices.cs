using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector3[] vertices
    {
        get => MayAccess("vertices") ? Array.ConvertAll(store.Read(VertexAttribute.Position), v => (Vector3)v) : [];
        set => SetVertices(value);
    }

    public Vector3[] normals
    {
        get => MayAccess("normals") ? Array.ConvertAll(store.Read(VertexAttribute.Normal), v => (Vector3)v) : [];
        set => SetNormals(value);
    }

    public Vector4[] tangents
    {
        get => MayAccess("tangents") ? store.Read(VertexAttribute.Tangent) : [];
        set => SetTangents(value);
    }

    public Color[] colors
    {
        get => MayAccess("colors") ? Array.ConvertAll(store.Read(VertexAttribute.Color), v => (Color)v) : [];
        set => SetColors(value);
    }

    public Color32[] colors32
    {
        get => Array.ConvertAll(colors, c => (Color32)c);
        set => SetColors(value);
    }

    public void GetVertices(List<Vector3> vertices) => Fill(vertices, this.vertices);

    public void GetNormals(List<Vector3> normals) => Fill(normals, this.normals);

    public void GetTangents(List<Vector4> tangents) => Fill(tangents, this.tangents);

    public void GetColors(List<Color> colors) => Fill(colors, this.colors);

    public void GetColors(List<Color32> colors) => Fill(colors, colors32);

    public void SetVertices(Vector3[] inVertices) => Write<Vector3>(VertexAttribute.Position, inVertices);

    public void SetVertices(Vector3[] inVertices, int start, int length) => Write<Vector3>(VertexAttribute.Position, inVertices.AsSpan(start, length));

    public void SetVertices(Vector3[] inVertices, int start, int length, MeshUpdateFlags flags) => SetVertices(inVertices, start, length);

    public void SetVertices(List<Vector3> inVertices) => Write<Vector3>(VertexAttribute.Position, CollectionsMarshal.AsSpan(inVertices));

    public void SetVertices(List<Vector3> inVertices, int start, int length) =>
        Write<Vector3>(VertexAttribute.Position, CollectionsMarshal.AsSpan(inVertices).Slice(start, length));

    public void SetVertices<T>(NativeArray<T> inVertices)
        where T : struct => WriteNative(VertexAttribute.Position, inVertices, 0, inVertices.Length);

    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length)
        where T : struct => WriteNative(VertexAttribute.Position, inVertices, start, length);

    public void SetNormals(Vector3[] inNormals) => Write<Vector3>(VertexAttribute.Normal, inNormals);

    public void SetNormals(Vector3[] inNormals, int start, int length) => Write<Vector3>(VertexAttribute.Normal, inNormals.AsSpan(start, length));

    public void SetNormals(List<Vector3> inNormals) => Write<Vector3>(VertexAttribute.Normal, CollectionsMarshal.AsSpan(inNormals));

    public void SetNormals(List<Vector3> inNormals, int start, int length) =>
        Write<Vector3>(VertexAttribute.Normal, CollectionsMarshal.AsSpan(inNormals).Slice(start, length));

    public void SetNormals<T>(NativeArray<T> inNormals)
        where T : struct => WriteNative(VertexAttribute.Normal, inNormals, 0, inNormals.Length);

    public void SetTangents(Vector4[] inTangents) => Write<Vector4>(VertexAttribute.Tangent, inTangents);

    public void SetTangents(List<Vector4> inTangents) => Write<Vector4>(VertexAttribute.Tangent, CollectionsMarshal.AsSpan(inTangents));

    public void SetColors(Color[] inColors) => Write<Color>(VertexAttribute.Color, inColors);

    public void SetColors(List<Color> inColors) => Write<Color>(VertexAttribute.Color, CollectionsMarshal.AsSpan(inColors));

    public void SetColors(Color32[] inColors) =>
        Store(VertexAttribute.Color, Array.ConvertAll(inColors ?? [], c => (Vector4)(Color)c), 4, VertexAttributeFormat.UNorm8);

    public void SetColors(List<Color32> inColors) => SetColors(inColors.ToArray());

    private static void Fill<T>(List<T> target, T[] values)
    {
        ArgumentNullException.ThrowIfNull(target);
        target.Clear();
        target.AddRange(values);
    }

    private void Write<T>(VertexAttribute attribute, ReadOnlySpan<T> values)
        where T : unmanaged
    {
        int dimension = Marshal.SizeOf<T>() / sizeof(float);
        ReadOnlySpan<float> floats = MemoryMarshal.Cast<T, float>(values);
        var expanded = new Vector4[values.Length];
        for (int i = 0; i < expanded.Length; i++)
        {
            for (int c = 0; c < dimension; c++)
            {
                expanded[i][c] = floats[(i * dimension) + c];
            }
        }

        Store(attribute, expanded, dimension, VertexAttributeFormat.Float32);
    }

    private void WriteNative<T>(VertexAttribute attribute, NativeArray<T> values, int start, int length)
        where T : struct
    {
        int size = NativeSpans.SizeOf<T>();
        ReadOnlySpan<byte> bytes = NativeSpans.Bytes(values).Slice(start * size, length * size);
        switch (size)
        {
            case 8:
                Write(attribute, MemoryMarshal.Cast<byte, Vector2>(bytes));
                break;
            case 12:
                Write(attribute, MemoryMarshal.Cast<byte, Vector3>(bytes));
                break;
            case 16:
                Write(attribute, MemoryMarshal.Cast<byte, Vector4>(bytes));
                break;
            default:
                throw new ArgumentException($"Elements of {size} bytes ({typeof(T).Name}) can't be {attribute} of mesh '{name}': pass 2 to 4 floats each.");
        }
    }

    private void Store(VertexAttribute attribute, Vector4[] values, int dimension, VertexAttributeFormat format)
    {
        if (!MayAccess(attribute.ToString()))
        {
            return;
        }

        if (attribute != VertexAttribute.Position)
        {
            if (values.Length == 0)
            {
                store.Remove(attribute);
                Changed();
                return;
            }

            if (values.Length != store.Count)
            {
                Debug.LogError($"Mesh.{attribute} is out of bounds. The supplied array needs to be the same size as the Mesh.vertices array: {values.Length} instead of {store.Count} on mesh '{name}'.");
                return;
            }
        }

        store.Set(attribute, values, dimension, format);
        Changed();
    }
}
