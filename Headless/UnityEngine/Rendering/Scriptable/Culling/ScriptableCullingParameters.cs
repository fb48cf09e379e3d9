using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>What ScriptableRenderContext.Cull keeps.</summary>
public record struct ScriptableCullingParameters
{
    public static readonly int maximumCullingPlaneCount = CullingPlanes.Count;
    public static readonly int layerCount = LayerDistances.Count;

    private CullingPlanes planes;
    private LayerDistances distances;
    private int planeCount;

    public int maximumVisibleLights { get; set; }
    public bool conservativeEnclosingSphere { get; set; }
    public int numIterationsEnclosingSphere { get; set; }

    public int cullingPlaneCount
    {
        readonly get => planeCount;
        set => planeCount = value >= 0 && value <= CullingPlanes.Count
            ? value
            : throw new ArgumentException($"{nameof(cullingPlaneCount)} must be at least 0 and at most {maximumCullingPlaneCount}, but was {value}.");
    }

    public bool isOrthographic { get; set; }
    public LODParameters lodParameters { get; set; }
    public uint cullingMask { get; set; }
    public Matrix4x4 cullingMatrix { get; set; }
    public Vector3 origin { get; set; }
    public float shadowDistance { get; set; }
    public float shadowNearPlaneOffset { get; set; }
    public CullingOptions cullingOptions { get; set; }
    public ReflectionProbeSortingCriteria reflectionProbeSortingCriteria { get; set; }
    public float accurateOcclusionThreshold { get; set; }
    public int maximumPortalCullingJobs { get; set; }
    public Matrix4x4 stereoViewMatrix { get; set; }
    public Matrix4x4 stereoProjectionMatrix { get; set; }
    public float stereoSeparationDistance { get; set; }

    /// <summary>Draws that are for one camera are culled for others.</summary>
    internal Camera? Camera { get; set; }

    internal CameraView View { get; set; }

    public readonly Plane GetCullingPlane(int index) => planes[Checked(index, planeCount)];

    public void SetCullingPlane(int index, Plane plane) => planes[Checked(index, planeCount)] = plane;

    public readonly float GetLayerCullingDistance(int layerIndex) => distances[Checked(layerIndex, layerCount)];

    public void SetLayerCullingDistance(int layerIndex, float distance) => distances[Checked(layerIndex, layerCount)] = distance;

    private static int Checked(int index, int count) => index >= 0 && index < count
        ? index
        : throw new ArgumentOutOfRangeException(nameof(index), $"The index must be at least 0 and less than {count}, but was {index}.");
}
