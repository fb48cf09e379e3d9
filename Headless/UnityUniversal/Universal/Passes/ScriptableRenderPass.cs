using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

public abstract class ScriptableRenderPass
{
    public RenderPassEvent renderPassEvent { get; set; } = RenderPassEvent.AfterRenderingOpaques;
    public ScriptableRenderPassInput input { get; private set; }

    public void ConfigureInput(ScriptableRenderPassInput passInput) => input = passInput;

    public virtual void Execute(ScriptableRenderContext context, ref RenderingData renderingData)
    {
    }

    public virtual void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
    {
    }
}
