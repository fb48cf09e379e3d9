namespace Headless.Shaders;

public enum ShaderStage
{
    Compute,
    Vertex,
    Geometry,
    Fragment,
}
