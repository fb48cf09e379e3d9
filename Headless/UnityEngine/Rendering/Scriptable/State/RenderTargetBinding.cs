namespace UnityEngine.Rendering;

/// <summary>Render targets with what happens to their contents.</summary>
public struct RenderTargetBinding
{
    public RenderTargetBinding(
        RenderTargetIdentifier colorRenderTarget, RenderBufferLoadAction colorLoadAction, RenderBufferStoreAction colorStoreAction,
        RenderTargetIdentifier depthRenderTarget, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction)
        : this([colorRenderTarget], [colorLoadAction], [colorStoreAction], depthRenderTarget, depthLoadAction, depthStoreAction)
    {
    }

    public RenderTargetBinding(
        RenderTargetIdentifier[] colorRenderTargets, RenderBufferLoadAction[] colorLoadActions, RenderBufferStoreAction[] colorStoreActions,
        RenderTargetIdentifier depthRenderTarget, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction)
    {
        this.colorRenderTargets = colorRenderTargets;
        this.colorLoadActions = colorLoadActions;
        this.colorStoreActions = colorStoreActions;
        this.depthRenderTarget = depthRenderTarget;
        this.depthLoadAction = depthLoadAction;
        this.depthStoreAction = depthStoreAction;
        flags = RenderTargetFlags.None;
    }

    public RenderTargetIdentifier[] colorRenderTargets { get; set; }
    public RenderTargetIdentifier depthRenderTarget { get; set; }
    public RenderBufferLoadAction[] colorLoadActions { get; set; }
    public RenderBufferStoreAction[] colorStoreActions { get; set; }
    public RenderBufferLoadAction depthLoadAction { get; set; }
    public RenderBufferStoreAction depthStoreAction { get; set; }
    public RenderTargetFlags flags { get; set; }
}
