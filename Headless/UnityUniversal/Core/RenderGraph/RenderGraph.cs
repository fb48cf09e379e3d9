namespace UnityEngine.Rendering.RenderGraphModule;

public class RenderGraph
{
}
