namespace UnityEngine.Rendering;

/// <summary>What a scriptable pipeline records a frame into.</summary>
public struct ScriptableRenderContext
{
    public readonly void ExecuteCommandBuffer(CommandBuffer commandBuffer) => Graphics.ExecuteCommandBuffer(commandBuffer);
}
