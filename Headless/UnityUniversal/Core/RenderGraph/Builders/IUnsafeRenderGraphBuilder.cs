namespace UnityEngine.Rendering.RenderGraphModule;

public interface IUnsafeRenderGraphBuilder : IBaseRenderGraphBuilder
{
    void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc)
        where PassData : class, new();
}
