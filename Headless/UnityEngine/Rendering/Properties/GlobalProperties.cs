namespace Headless.Engine;

/// <summary>Values set by Shader.SetGlobal... and by the engine itself.</summary>
internal static class GlobalProperties
{
    public static PropertySheet Sheet { get; } = new();
}
