namespace Headless.Shaders;

/// <summary>A .shader file.</summary>
public sealed class ShaderLabSource
{
    /// <summary>Path for messages, relative to the project where it lies in it.</summary>
    public required string Path { get; init; }
    public required string Name { get; init; }
    public required IReadOnlyList<ShaderProperty> Properties { get; init; }

    /// <summary>SubShaders whose PackageRequirements are met, in order.</summary>
    public required IReadOnlyList<SubShader> SubShaders { get; init; }

    /// <summary>Name of the fallback shader, "" for none or "Fallback Off".</summary>
    public required string Fallback { get; init; }

    /// <exception cref="ShaderCompileException">The file is not ShaderLab, or uses what is not supported.</exception>
    public static ShaderLabSource Parse(string path, IncludeResolver includes) =>
        ParseText(System.IO.Path.GetFullPath(path), includes.Read(path), includes);

    /// <summary>Parses text that is not on disk; <paramref name="path"/> places it for relative includes and messages.</summary>
    public static ShaderLabSource ParseText(string path, string text, IncludeResolver includes)
    {
        string shown = includes.Shown(path);
        ShaderLabReader reader = new(shown, new ShaderLabLexer(shown, text).Read());
        return new ShaderLabParser(path, reader, includes).Read();
    }
}
