using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Writes out swizzles of matrices, which glslang cannot translate: M._m00_m10 becomes float2(M._m00, M._m10).</summary>
internal static partial class MatrixSwizzles
{
    public static string Rewrite(string text) => Swizzle().Replace(text, match =>
    {
        string matrix = match.Groups["matrix"].Value;
        CaptureCollection elements = match.Groups["element"].Captures;
        return $"float{elements.Count}({string.Join(", ", elements.Select(e => matrix + "." + e.Value))})";
    });

    // One that is assigned to stays as it is: that, glslang can do.
    [GeneratedRegex(
        @"\b(?<matrix>[A-Za-z_]\w*(?:\[\w+\]|\.[A-Za-z]\w*)*)\.(?:(?<element>_m[0-3][0-3]){2,4}|(?<element>_[1-4][1-4]){2,4})\b(?!\s*[-+*/]?=[^=])")]
    private static partial Regex Swizzle();
}
