using System.Text.RegularExpressions;

namespace Headless.Shaders.Preprocessing;

/// <summary>Splits what stands behind a directive: names, numbers, texts and operators.</summary>
internal static partial class DirectiveTokens
{
    public static string[] Read(string text) => [.. Token().Matches(text).Select(m => m.Value)];

    public static bool IsName(string token) => char.IsLetter(token[0]) || token[0] == '_';

    [GeneratedRegex("""\w+|"[^"]*"|&&|\|\||[=!<>]=|<<|>>|##|\S""")]
    private static partial Regex Token();
}
