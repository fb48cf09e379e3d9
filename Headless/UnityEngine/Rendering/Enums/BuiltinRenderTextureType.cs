namespace UnityEngine.Rendering;

public enum BuiltinRenderTextureType
{
    PropertyName = -4,
    BufferPtr = -3,
    RenderTexture = -2,
    BindableTexture = -1,
    None = 0,
    CurrentActive = 1,
    CameraTarget = 2,
    Depth = 3,
    DepthNormals = 4,
    ResolvedDepth = 5,
}
