namespace UnityEngine.Rendering.RenderGraphModule;

public struct ImportResourceParams
{
    public bool clearOnFirstUse;
    public Color clearColor;
    public bool discardOnLastUse;
}
