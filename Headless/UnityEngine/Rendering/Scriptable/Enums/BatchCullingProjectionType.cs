namespace UnityEngine.Rendering;

public enum BatchCullingProjectionType
{
    Unknown = 0,
    Perspective = 1,
    Orthographic = 2,
}
