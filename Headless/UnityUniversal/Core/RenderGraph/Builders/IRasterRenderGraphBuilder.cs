namespace UnityEngine.Rendering.RenderGraphModule;

public interface IRasterRenderGraphBuilder : IBaseRenderGraphBuilder
{
    void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags = AccessFlags.Write) => SetRenderAttachment(tex, index, flags, 0, -1);

    void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags, int mipLevel, int depthSlice);

    void SetRenderAttachmentDepth(TextureHandle tex, AccessFlags flags = AccessFlags.Write) => SetRenderAttachmentDepth(tex, flags, 0, -1);

    void SetRenderAttachmentDepth(TextureHandle tex, AccessFlags flags, int mipLevel, int depthSlice);

    void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
        where PassData : class, new();
}
