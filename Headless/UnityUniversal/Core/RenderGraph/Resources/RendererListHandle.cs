namespace UnityEngine.Rendering.RenderGraphModule;

public readonly struct RendererListHandle
{
    private readonly RendererList list;
    private readonly bool valid;

    internal RendererListHandle(RendererList list) => (this.list, valid) = (list, true);

    public static implicit operator RendererList(RendererListHandle rendererList) => rendererList.list;

    public bool IsValid() => valid;
}
