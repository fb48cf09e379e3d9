using System;

namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>Fills a pass; it belongs to the graph once the builder is disposed of.</summary>
internal sealed class GraphBuilder(RenderGraph graph, GraphPass pass) : IRasterRenderGraphBuilder, IUnsafeRenderGraphBuilder, IComputeRenderGraphBuilder
{
    public void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read) => Use(Require(input), flags);

    public void UseGlobalTexture(int propertyId, AccessFlags flags = AccessFlags.Read) => pass.GlobalsRead.Add(propertyId);

    public void UseAllGlobalTextures(bool enable) => pass.ReadsAllGlobals = enable;

    public void SetGlobalTextureAfterPass(in TextureHandle input, int propertyId) => pass.GlobalsAfter.Add((Require(input), propertyId));

    public TextureHandle CreateTransientTexture(in TextureDesc desc)
    {
        TextureHandle made = graph.CreateTexture(desc);
        Use(made.Texture!, AccessFlags.ReadWrite);
        return made;
    }

    public void UseRendererList(in RendererListHandle input)
    {
    }

    public void AllowPassCulling(bool value) => pass.AllowsCulling = value;

    public void AllowGlobalStateModification(bool value) => pass.AllowsGlobalState = value;

    public void EnableAsyncCompute(bool value)
    {
    }

    public void SetRenderAttachment(TextureHandle tex, int index, AccessFlags flags, int mipLevel, int depthSlice)
    {
        GraphTexture texture = Require(tex);
        pass.Colors.Add(new GraphPass.Attachment(texture, index, flags, mipLevel, depthSlice));
        Use(texture, flags);
    }

    public void SetRenderAttachmentDepth(TextureHandle tex, AccessFlags flags, int mipLevel, int depthSlice)
    {
        GraphTexture texture = Require(tex);
        pass.Depth = new GraphPass.Attachment(texture, 0, flags, mipLevel, depthSlice);
        Use(texture, flags);
    }

    public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, RasterGraphContext> renderFunc)
        where PassData : class, new() => pass.Function = run => renderFunc((PassData)pass.Data, new RasterGraphContext(run, pass));

    public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
        where PassData : class, new() => pass.Function = run => renderFunc((PassData)pass.Data, new UnsafeGraphContext(run, pass));

    public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, ComputeGraphContext> renderFunc)
        where PassData : class, new() => pass.Function = run => renderFunc((PassData)pass.Data, new ComputeGraphContext(run, pass));

    public void Dispose() => graph.Add(pass);

    private GraphTexture Require(in TextureHandle handle) => handle.Texture
        ?? throw new InvalidOperationException($"RenderGraph pass '{pass.Name}': the texture handle is invalid: it is of another frame, or was never made.");

    private void Use(GraphTexture texture, AccessFlags flags)
    {
        if ((flags & AccessFlags.Read) != 0)
        {
            pass.Read.Add(texture);
        }

        if ((flags & (AccessFlags.Write | AccessFlags.Discard)) != 0)
        {
            pass.Written.Add(texture);
        }
    }
}
