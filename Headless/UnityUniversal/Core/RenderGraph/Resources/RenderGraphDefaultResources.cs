namespace UnityEngine.Rendering.RenderGraphModule;

public class RenderGraphDefaultResources
{
    private readonly RenderGraph graph;

    internal RenderGraphDefaultResources(RenderGraph graph) => this.graph = graph;

    public TextureHandle whiteTexture => graph.ImportTexture(RTHandles.Alloc(Texture2D.whiteTexture));
    public TextureHandle blackTexture => graph.ImportTexture(RTHandles.Alloc(Texture2D.blackTexture));
}
