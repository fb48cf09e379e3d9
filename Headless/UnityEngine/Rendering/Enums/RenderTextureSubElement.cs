namespace UnityEngine.Rendering;

public enum RenderTextureSubElement
{
    Color = 0,
    Depth = 1,
    Stencil = 2,
    Default = 3,
}
