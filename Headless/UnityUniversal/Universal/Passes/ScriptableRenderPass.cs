using System.Collections.Generic;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>A pass at one of the renderer's events.</summary>
public abstract class ScriptableRenderPass : IRenderGraphRecorder
{
    public RenderPassEvent renderPassEvent { get; set; } = RenderPassEvent.AfterRenderingOpaques;
    public ScriptableRenderPassInput input { get; private set; }
    public bool requiresIntermediateTexture { get; set; }

    /// <summary>In compatibility mode, where the pass draws to others than the camera's.</summary>
    public RTHandle? colorAttachmentHandle { get; private set; }

    /// <summary>In compatibility mode, where the pass draws to others than the camera's.</summary>
    public RTHandle? depthAttachmentHandle { get; private set; }

    public ClearFlag clearFlag { get; private set; }
    public Color clearColor { get; private set; } = Color.black;

    protected internal ProfilingSampler profilingSampler { get; set; } = new(nameof(ScriptableRenderPass));

    public static bool operator <(ScriptableRenderPass lhs, ScriptableRenderPass rhs) => lhs.renderPassEvent < rhs.renderPassEvent;

    public static bool operator >(ScriptableRenderPass lhs, ScriptableRenderPass rhs) => lhs.renderPassEvent > rhs.renderPassEvent;

    public void ConfigureInput(ScriptableRenderPassInput passInput) => input = passInput;

    public void ConfigureTarget(RTHandle colorAttachment) => ConfigureTarget(colorAttachment, colorAttachment);

    public void ConfigureTarget(RTHandle colorAttachment, RTHandle depthAttachment) =>
        (colorAttachmentHandle, depthAttachmentHandle) = (colorAttachment, depthAttachment);

    public void ResetTarget() => (colorAttachmentHandle, depthAttachmentHandle) = (null, null);

    public void ConfigureClear(ClearFlag clearFlag, Color clearColor) => (this.clearFlag, this.clearColor) = (clearFlag, clearColor);

    public virtual void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData) =>
        Debug.LogWarning($"The render pass {GetType()} does not have an implementation of the RecordRenderGraph method. Please implement this method, or consider turning on Compatibility Mode (RenderGraph disabled) in the menu Edit > Project Settings > Graphics > URP. Otherwise the render pass will have no effect.");

    public virtual void OnCameraSetup(CommandBuffer cmd, ref RenderingData renderingData)
    {
    }

    public virtual void Configure(CommandBuffer cmd, RenderTextureDescriptor cameraTextureDescriptor)
    {
    }

    public virtual void Execute(ScriptableRenderContext context, ref RenderingData renderingData) =>
        Debug.LogWarning("Execute is not implemented, the pass " + GetType() + " won't be executed in the current render loop.");

    public virtual void OnCameraCleanup(CommandBuffer cmd)
    {
    }

    public DrawingSettings CreateDrawingSettings(ShaderTagId shaderTagId, ref RenderingData renderingData, SortingCriteria sortingCriteria) =>
        Drawing.Settings([shaderTagId], renderingData.Frame, sortingCriteria);

    public DrawingSettings CreateDrawingSettings(List<ShaderTagId> shaderTagIdList, ref RenderingData renderingData, SortingCriteria sortingCriteria) =>
        Drawing.Settings(shaderTagIdList, renderingData.Frame, sortingCriteria);
}
