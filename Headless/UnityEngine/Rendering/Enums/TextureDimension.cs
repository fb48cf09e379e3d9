namespace UnityEngine.Rendering;

public enum TextureDimension
{
    Unknown = -1,
    None = 0,
    Any = 1,
    Tex2D = 2,
    Tex3D = 3,
    Cube = 4,
    Tex2DArray = 5,
    CubeArray = 6,
}
