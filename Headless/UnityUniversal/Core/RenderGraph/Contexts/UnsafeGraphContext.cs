namespace UnityEngine.Rendering.RenderGraphModule;

public class UnsafeGraphContext
{
    public UnsafeCommandBuffer cmd;

    private readonly GraphRun run;

    internal UnsafeGraphContext(GraphRun run, GraphPass pass)
    {
        this.run = run;
        cmd = new UnsafeCommandBuffer(run.Commands) { Pass = pass, Run = run };
    }

    public RenderGraphDefaultResources defaultResources => run.DefaultResources;
}
