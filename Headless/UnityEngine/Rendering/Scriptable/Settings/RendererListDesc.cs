using System;
using Unity.Collections;

namespace UnityEngine.Rendering.RendererUtils;

/// <summary>The same as RendererListParams in fewer words.</summary>
public struct RendererListDesc
{
    public SortingCriteria sortingCriteria;
    public PerObjectData rendererConfiguration;
    public RenderQueueRange renderQueueRange;
    public RenderStateBlock? stateBlock;
    public Shader? overrideShader;
    public Material? overrideMaterial;
    public bool excludeObjectMotionVectors;
    public int layerMask;
    public uint renderingLayerMask;
    public int overrideMaterialPassIndex;
    public int overrideShaderPassIndex;

    private readonly CullingResults culled;
    private readonly Camera? viewer;
    private readonly ShaderTagId[] passes;

    public RendererListDesc(ShaderTagId passName, CullingResults cullingResult, Camera camera)
        : this([passName], cullingResult, camera)
    {
    }

    public RendererListDesc(ShaderTagId[] passNames, CullingResults cullingResult, Camera camera)
        : this()
    {
        (passes, culled, viewer) = (passNames, cullingResult, camera);
        layerMask = -1;
        renderingLayerMask = uint.MaxValue;
    }

    public static RendererListParams ConvertToParameters(in RendererListDesc desc)
    {
        if (!desc.IsValid())
        {
            return RendererListParams.Invalid;
        }

        var sorting = new SortingSettings(desc.viewer!) { criteria = desc.sortingCriteria };
        var drawing = new DrawingSettings(desc.passes[0], sorting)
        {
            perObjectData = desc.rendererConfiguration,
            overrideMaterial = desc.overrideMaterial,
            overrideMaterialPassIndex = desc.overrideMaterialPassIndex,
            overrideShader = desc.overrideShader,
            overrideShaderPassIndex = desc.overrideShaderPassIndex,
        };
        for (int i = 1; i < desc.passes.Length; i++)
        {
            drawing.SetShaderPassName(i, desc.passes[i]);
        }

        var filtering = new FilteringSettings(desc.renderQueueRange, desc.layerMask, desc.renderingLayerMask)
        {
            excludeMotionVectorObjects = desc.excludeObjectMotionVectors,
        };
        var list = new RendererListParams(desc.culled, drawing, filtering);
        if (desc.stateBlock is { } block)
        {
            list.tagValues = new NativeArray<ShaderTagId>(1, Allocator.Temp);
            list.stateBlocks = new NativeArray<RenderStateBlock>([block], Allocator.Temp);
        }

        return list;
    }

    public readonly bool IsValid() => viewer != null && passes is { Length: > 0 } && renderQueueRange != default;
}
