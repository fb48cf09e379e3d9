using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine.Rendering;

/// <summary>What a camera sees: objects for renderer lists, lights and reflection probes.</summary>
public struct CullingResults : IEquatable<CullingResults>
{
    internal CullingResults(CulledScene scene) => Scene = scene;

    /// <summary>The main directional light first, then the other directional lights, then lamps by what reaches the camera.</summary>
    public readonly NativeArray<VisibleLight> visibleLights => Required.Lights.Visible;

    /// <summary>None: lights that reach nothing in view are left out.</summary>
    public readonly NativeArray<VisibleLight> visibleOffscreenVertexLights => NativeMemoryOwner.Array<VisibleLight>([]);

    public readonly NativeArray<VisibleReflectionProbe> visibleReflectionProbes => Required.Probes.Visible;

    /// <summary>How many lights the objects in view have together.</summary>
    public readonly int lightIndexCount => Required.LightIndexCount;

    public readonly int reflectionProbeIndexCount => Required.ProbeIndexCount;

    public readonly int lightAndReflectionProbeIndexCount => lightIndexCount + reflectionProbeIndexCount;

    internal CulledScene? Scene { get; }

    private readonly CulledScene Required => Scene ?? throw new InvalidOperationException("CullingResults is empty: ScriptableRenderContext.Cull makes them.");

    public static bool operator ==(CullingResults left, CullingResults right) => left.Equals(right);

    public static bool operator !=(CullingResults left, CullingResults right) => !left.Equals(right);

    /// <summary>The number that shaders know each visible light by.</summary>
    public readonly NativeArray<int> GetLightIndexMap(Allocator allocator) => new(Required.Lights.IndexMap, allocator);

    /// <summary>Numbers for unity_LightIndices; -1 leaves a light out.</summary>
    public readonly void SetLightIndexMap(NativeArray<int> lightIndexMap) => Required.Lights.SetIndexMap(lightIndexMap);

    public readonly NativeArray<int> GetReflectionProbeIndexMap(Allocator allocator) => new(Required.Probes.IndexMap, allocator);

    public readonly void SetReflectionProbeIndexMap(NativeArray<int> lightIndexMap) => Required.Probes.SetIndexMap(lightIndexMap);

    /// <summary>A box around everything whose shadow may be seen; false where there is nothing.</summary>
    public readonly bool GetShadowCasterBounds(int lightIndex, out Bounds outBounds) => Required.Shadows(lightIndex).Bounds(out outBounds);

    public readonly bool ComputeSpotShadowMatricesAndCullingPrimitives(
        int activeLightIndex, out Matrix4x4 viewMatrix, out Matrix4x4 projMatrix, out ShadowSplitData shadowSplitData)
    {
        (viewMatrix, projMatrix, shadowSplitData) = ShadowViews.Spot(Required.Lights[activeLightIndex]);
        return Required.Shadows(activeLightIndex).Bounds(out _);
    }

    public readonly bool ComputePointShadowMatricesAndCullingPrimitives(
        int activeLightIndex, CubemapFace cubemapFace, float fovBias, out Matrix4x4 viewMatrix, out Matrix4x4 projMatrix, out ShadowSplitData shadowSplitData)
    {
        (viewMatrix, projMatrix, shadowSplitData) = ShadowViews.Point(Required.Lights[activeLightIndex], cubemapFace, fovBias);
        return Required.Shadows(activeLightIndex).Bounds(out _);
    }

    /// <summary>The view of one cascade: its sphere is that round a slice of what the camera sees, moved by whole texels.</summary>
    /// <param name="splitRatio">Where the first three cascades end, as shares of the shadow distance.</param>
    public readonly bool ComputeDirectionalShadowMatricesAndCullingPrimitives(
        int activeLightIndex, int splitIndex, int splitCount, Vector3 splitRatio, int shadowResolution, float shadowNearPlaneOffset,
        out Matrix4x4 viewMatrix, out Matrix4x4 projMatrix, out ShadowSplitData shadowSplitData)
    {
        bool hasCasters = Required.Shadows(activeLightIndex).Bounds(out Bounds casters);
        var slice = CascadeSlice.Of(Required.View, Required.ShadowDistance, splitIndex, splitCount, splitRatio);
        (viewMatrix, projMatrix, shadowSplitData) =
            ShadowViews.Directional(Required.Lights[activeLightIndex], slice, shadowResolution, shadowNearPlaneOffset, hasCasters ? casters : null);
        return hasCasters;
    }

    public readonly bool Equals(CullingResults other) => ReferenceEquals(Scene, other.Scene);

    public override readonly bool Equals(object? obj) => obj is CullingResults other && Equals(other);

    public override readonly int GetHashCode() => Scene?.GetHashCode() ?? 0;
}
