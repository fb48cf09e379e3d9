using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Rendering.RenderGraphModule;

public struct RenderTargetInfo
{
    public int width;
    public int height;
    public int volumeDepth;
    public int msaaSamples;
    public GraphicsFormat format;
    public bool bindMS;
}
