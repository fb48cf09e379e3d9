using Headless.Files;

namespace Headless.Shaders;

/// <summary>A shader source that cannot be imported or compiled, in the form of Unity's console.</summary>
public sealed class ShaderCompileException(string file, int line, string message)
    : BadFileException(Format(file, line, message))
{
    public string File { get; } = file;

    /// <summary>1-based; 0 when the message concerns the whole file.</summary>
    public int Line { get; } = line;

    /// <summary>What is wrong, without the place.</summary>
    public string Problem { get; } = message;

    private static string Format(string file, int line, string message)
    {
        string name = Path.GetFileName(file);
        return line > 0
            ? $"Shader error in '{name}': {message} at {file}({line}) (on d3d11)"
            : $"Shader error in '{name}': {message} (on d3d11) at {file}";
    }
}
