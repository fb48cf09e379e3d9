namespace UnityEngine.Experimental.Rendering;

public enum DefaultFormat
{
    LDR = 0,
    HDR = 1,
    DepthStencil = 2,
    Shadow = 3,
    Video = 4,
}
