namespace UnityEngine.Rendering.RenderGraphModule;

public interface IComputeRenderGraphBuilder : IBaseRenderGraphBuilder
{
    void SetRenderFunc<PassData>(BaseRenderFunc<PassData, ComputeGraphContext> renderFunc)
        where PassData : class, new();
}
