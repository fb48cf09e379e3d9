using Unity.Collections;

namespace UnityEngine.Rendering.Universal;

/// <summary>Depth priming: the prepass has written depth, shading tests for equality and writes none.</summary>
internal static class Primed
{
    public static void Apply(ref RendererListParams list)
    {
        var state = new RenderStateBlock(RenderStateMask.Depth) { depthState = new DepthState(false, CompareFunction.Equal) };
        list.isPassTagName = false;
        list.tagName = ShaderTagId.none;
        list.tagValues = new NativeArray<ShaderTagId>([ShaderTagId.none], Allocator.Temp);
        list.stateBlocks = new NativeArray<RenderStateBlock>([state], Allocator.Temp);
    }
}
