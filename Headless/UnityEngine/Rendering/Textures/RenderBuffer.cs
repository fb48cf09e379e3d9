namespace UnityEngine;

public struct RenderBuffer
{
    internal RenderBuffer(RenderTexture? texture, bool depth)
    {
        Texture = texture;
        IsDepth = depth;
    }

    internal RenderTexture? Texture { get; }
    internal bool IsDepth { get; }
}
