namespace UnityEngine.Rendering.RenderGraphModule;

public struct RasterGraphContext
{
    public RasterCommandBuffer cmd;

    private readonly GraphRun run;

    internal RasterGraphContext(GraphRun run, GraphPass pass)
    {
        this.run = run;
        cmd = new RasterCommandBuffer(run.Commands) { Pass = pass, Run = run };
    }

    public readonly RenderGraphDefaultResources defaultResources => run.DefaultResources;
}
