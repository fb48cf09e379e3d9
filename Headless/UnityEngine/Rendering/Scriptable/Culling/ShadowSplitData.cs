using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>What part of the scene a shadow cascade covers.</summary>
public record struct ShadowSplitData
{
    public static readonly int maximumCullingPlaneCount = CullingPlanes.Count;

    private CullingPlanes planes;
    private int planeCount;

    public int cullingPlaneCount
    {
        readonly get => planeCount;
        set => planeCount = value >= 0 && value <= CullingPlanes.Count
            ? value
            : throw new ArgumentException($"Value should range from 0 to ShadowSplitData.maximumCullingPlaneCount ({maximumCullingPlaneCount}), but was {value}.");
    }

    /// <summary>Its place and, as w, its radius; none where the radius is 0.</summary>
    public Vector4 cullingSphere { get; set; }

    public Matrix4x4 cullingMatrix { get; set; }
    public float cullingNearPlane { get; set; }
    public float shadowCascadeBlendCullingFactor { get; set; }

    public readonly Plane GetCullingPlane(int index) => planes[Checked(index)];

    public void SetCullingPlane(int index, Plane plane) => planes[Checked(index)] = plane;

    private readonly int Checked(int index) => index >= 0 && index < planeCount
        ? index
        : throw new ArgumentException($"Index must be at least 0 and less than cullingPlaneCount ({planeCount}), but was {index}.");
}
