namespace Headless.Shaders;

public enum ShaderPropertyType
{
    Float,
    Range,
    Integer,
    Color,
    Vector,
    Texture2D,
    Texture3D,
    TextureCube,
    Texture2DArray,
    TextureCubeArray,
}
