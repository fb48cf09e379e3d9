using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A named shape of a mesh: offsets of its vertices at one or more weights, in rising order.</summary>
internal sealed class BlendShape(string name)
{
    private readonly List<Frame> frames = [];

    public sealed record Frame(float Weight, Vector3[] Vertices, Vector3[]? Normals, Vector3[]? Tangents);

    public string Name => name;
    public IReadOnlyList<Frame> Frames => frames;

    public void Add(Frame frame) => frames.Add(frame);

    /// <summary>Adds the offsets at a weight: linear from none at 0 to the first frame, between frames, and on beyond the last one.</summary>
    public void AddTo(float weight, Vector3[] vertices, Vector3[] normals)
    {
        if (weight == 0f)
        {
            return;
        }

        int next = 0;
        while (next < frames.Count - 1 && weight > frames[next].Weight)
        {
            next++;
        }

        float low = next > 0 ? frames[next - 1].Weight : 0f;
        float t = (weight - low) / (frames[next].Weight - low);
        Add(frames[next], t, vertices, normals);
        if (next > 0)
        {
            Add(frames[next - 1], 1f - t, vertices, normals);
        }
    }

    private static void Add(Frame frame, float share, Vector3[] vertices, Vector3[] normals)
    {
        for (int i = 0; i < vertices.Length; i++)
        {
            vertices[i] += share * frame.Vertices[i];
        }

        for (int i = 0; i < Math.Min(normals.Length, frame.Normals?.Length ?? 0); i++)
        {
            normals[i] += share * frame.Normals![i];
        }
    }
}
