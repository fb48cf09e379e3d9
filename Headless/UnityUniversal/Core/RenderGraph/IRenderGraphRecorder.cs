namespace UnityEngine.Rendering.RenderGraphModule;

public interface IRenderGraphRecorder
{
    void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData);
}
