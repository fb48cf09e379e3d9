using System;
using Unity.Collections;

namespace UnityEngine.Rendering;

/// <summary>What a renderer list is made of.</summary>
public struct RendererListParams : IEquatable<RendererListParams>
{
    public static readonly RendererListParams Invalid;

    public CullingResults cullingResults;
    public DrawingSettings drawSettings;
    public FilteringSettings filteringSettings;
    public ShaderTagId tagName;
    public bool isPassTagName;
    public NativeArray<ShaderTagId>? tagValues;
    public NativeArray<RenderStateBlock>? stateBlocks;

    public RendererListParams(CullingResults cullingResults, DrawingSettings drawSettings, FilteringSettings filteringSettings)
        : this()
    {
        this.cullingResults = cullingResults;
        this.drawSettings = drawSettings;
        this.filteringSettings = filteringSettings;
    }

    public static bool operator ==(RendererListParams left, RendererListParams right) => left.Equals(right);

    public static bool operator !=(RendererListParams left, RendererListParams right) => !left.Equals(right);

    public readonly bool Equals(RendererListParams other) => cullingResults == other.cullingResults && drawSettings == other.drawSettings
        && filteringSettings == other.filteringSettings && tagName == other.tagName && isPassTagName == other.isPassTagName
        && tagValues.Equals(other.tagValues) && stateBlocks.Equals(other.stateBlocks);

    public override readonly bool Equals(object? obj) => obj is RendererListParams other && Equals(other);

    public override readonly int GetHashCode() => HashCode.Combine(cullingResults, drawSettings, filteringSettings, tagName, isPassTagName);
}
