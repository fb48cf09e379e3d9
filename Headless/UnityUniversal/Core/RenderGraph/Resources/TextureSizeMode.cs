namespace UnityEngine.Rendering.RenderGraphModule;

public enum TextureSizeMode
{
    Explicit,
    Scale,
    Functor,
}
