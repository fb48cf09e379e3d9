using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void DrawRendererList(RendererList rendererList) => Add(new DrawListCommand(rendererList));

    /// <summary>Added to the Offset of every pass until it is set to 0: units of depth, and depth a slope.</summary>
    public void SetGlobalDepthBias(float bias, float slopeBias) => Add(_ => Drawer.DepthBias = (bias, slopeBias));

    /// <summary>The commands of now, for another to run.</summary>
    internal GpuCommand Snapshot() => new CommandSequence([.. commands]);
}
