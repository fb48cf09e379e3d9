namespace Headless.Shaders;

/// <param name="Words">Words after "#pragma", comments cut off.</param>
internal sealed record PragmaLine(string File, int Line, IReadOnlyList<string> Words)
{
    public static string[] Split(string argument) => argument.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
}
