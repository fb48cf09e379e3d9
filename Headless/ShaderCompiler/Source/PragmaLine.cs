namespace Headless.Shaders;

/// <param name="Words">Words after "#pragma", line comments cut off.</param>
internal sealed record PragmaLine(string File, int Line, IReadOnlyList<string> Words);
