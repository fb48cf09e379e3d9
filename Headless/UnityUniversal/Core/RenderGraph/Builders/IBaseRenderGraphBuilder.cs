using System;

namespace UnityEngine.Rendering.RenderGraphModule;

public interface IBaseRenderGraphBuilder : IDisposable
{
    void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read);

    void UseGlobalTexture(int propertyId, AccessFlags flags = AccessFlags.Read);

    void UseAllGlobalTextures(bool enable);

    void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId);

    TextureHandle CreateTransientTexture(in TextureDesc desc);

    void UseRendererList(in RendererListHandle input);

    void AllowPassCulling(bool value);

    void AllowGlobalStateModification(bool value);

    void EnableAsyncCompute(bool value);
}
