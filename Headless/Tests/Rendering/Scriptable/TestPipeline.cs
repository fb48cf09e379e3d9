using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>A pipeline that draws with a delegate.</summary>
public class TestPipeline(Action<ScriptableRenderContext, Camera[]> render) : RenderPipeline
{
    public Action? Disposed { get; set; }

    protected override void Render(ScriptableRenderContext context, Camera[] cameras)
    {
        BeginFrameRendering(context, cameras);
        foreach (Camera camera in cameras)
        {
            BeginCameraRendering(context, camera);
            EndCameraRendering(context, camera);
        }

        render(context, cameras);
        EndFrameRendering(context, cameras);
    }

    protected override void Dispose(bool disposing) => Disposed?.Invoke();
}

/// <summary>The same of another class.</summary>
public sealed class OtherPipeline(Action<ScriptableRenderContext, Camera[]> render) : TestPipeline(render);

public sealed class TestPipelineAsset : RenderPipelineAsset
{
    public Func<RenderPipeline> Make { get; set; } = () => new TestPipeline((_, _) => { });
    public string Tag { get; set; } = string.Empty;

    public override string renderPipelineShaderTag => Tag;

    public void Change() => OnValidate();

    protected override RenderPipeline CreatePipeline() => Make();
}
