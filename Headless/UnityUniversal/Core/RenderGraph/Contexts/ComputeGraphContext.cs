namespace UnityEngine.Rendering.RenderGraphModule;

public class ComputeGraphContext
{
    public ComputeCommandBuffer cmd;

    private readonly GraphRun run;

    internal ComputeGraphContext(GraphRun run, GraphPass pass)
    {
        this.run = run;
        cmd = new ComputeCommandBuffer(run.Commands) { Pass = pass, Run = run };
    }

    public RenderGraphDefaultResources defaultResources => run.DefaultResources;
}
