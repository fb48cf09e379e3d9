using System.Collections.Generic;
using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector2[] uv
    {
        get => ReadUV(0);
        set => SetUVs(0, value);
    }

    public Vector2[] uv2
    {
        get => ReadUV(1);
        set => SetUVs(1, value);
    }

    public Vector2[] uv3
    {
        get => ReadUV(2);
        set => SetUVs(2, value);
    }

    public Vector2[] uv4
    {
        get => ReadUV(3);
        set => SetUVs(3, value);
    }

    public Vector2[] uv5
    {
        get => ReadUV(4);
        set => SetUVs(4, value);
    }

    public Vector2[] uv6
    {
        get => ReadUV(5);
        set => SetUVs(5, value);
    }

    public Vector2[] uv7
    {
        get => ReadUV(6);
        set => SetUVs(6, value);
    }

    public Vector2[] uv8
    {
        get => ReadUV(7);
        set => SetUVs(7, value);
    }

    public void GetUVs(int channel, List<Vector2> uvs) =>
        Fill(uvs, Array.ConvertAll(MayAccess("uvs") ? store.Read(Channel(channel)) : [], v => (Vector2)v));

    public void SetUVs(int channel, Vector2[] uvs) => Write<Vector2>(Channel(channel), uvs);

    public void SetUVs(int channel, Vector2[] uvs, int start, int length) => Write<Vector2>(Channel(channel), uvs.AsSpan(start, length));

    public void SetUVs(int channel, List<Vector2> uvs) => Write<Vector2>(Channel(channel), CollectionsMarshal.AsSpan(uvs));

    public void SetUVs(int channel, List<Vector2> uvs, int start, int length) =>
        Write<Vector2>(Channel(channel), CollectionsMarshal.AsSpan(uvs).Slice(start, length));

    public void GetUVs(int channel, List<Vector3> uvs) =>
        Fill(uvs, Array.ConvertAll(MayAccess("uvs") ? store.Read(Channel(channel)) : [], v => (Vector3)v));

    public void SetUVs(int channel, Vector3[] uvs) => Write<Vector3>(Channel(channel), uvs);

    public void SetUVs(int channel, Vector3[] uvs, int start, int length) => Write<Vector3>(Channel(channel), uvs.AsSpan(start, length));

    public void SetUVs(int channel, List<Vector3> uvs) => Write<Vector3>(Channel(channel), CollectionsMarshal.AsSpan(uvs));

    public void SetUVs(int channel, List<Vector3> uvs, int start, int length) =>
        Write<Vector3>(Channel(channel), CollectionsMarshal.AsSpan(uvs).Slice(start, length));

    public void GetUVs(int channel, List<Vector4> uvs) =>
        Fill(uvs, Array.ConvertAll(MayAccess("uvs") ? store.Read(Channel(channel)) : [], v => (Vector4)v));

    public void SetUVs(int channel, Vector4[] uvs) => Write<Vector4>(Channel(channel), uvs);

    public void SetUVs(int channel, Vector4[] uvs, int start, int length) => Write<Vector4>(Channel(channel), uvs.AsSpan(start, length));

    public void SetUVs(int channel, List<Vector4> uvs) => Write<Vector4>(Channel(channel), CollectionsMarshal.AsSpan(uvs));

    public void SetUVs(int channel, List<Vector4> uvs, int start, int length) =>
        Write<Vector4>(Channel(channel), CollectionsMarshal.AsSpan(uvs).Slice(start, length));

    public void SetUVs<T>(int channel, NativeArray<T> uvs)
        where T : struct => WriteNative(Channel(channel), uvs, 0, uvs.Length);

    private static VertexAttribute Channel(int channel) => (uint)channel < 8u
        ? VertexAttribute.TexCoord0 + channel
        : throw new ArgumentOutOfRangeException(nameof(channel), $"The uv index is invalid. Must be in the range 0 to 7, not {channel}.");

    private Vector2[] ReadUV(int channel) =>
        MayAccess("uvs") ? Array.ConvertAll(store.Read(Channel(channel)), v => new Vector2(v.x, v.y)) : [];
}
