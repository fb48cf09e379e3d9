using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Names that only the source tells apart.</summary>
internal static partial class SourceNames
{
    /// <summary>Whether a text may declare byte address buffers, before macros and #if are worked out.</summary>
    public static bool MayHaveRawBuffers(string text) => text.Contains("ByteAddressBuffer", StringComparison.Ordinal);

    /// <summary>Variables declared as ByteAddressBuffer or RWByteAddressBuffer.</summary>
    public static HashSet<string> RawBuffers(string text)
    {
        HashSet<string> names = [];
        foreach (Match match in RawBufferDeclaration().Matches(text))
        {
            foreach (string name in RegisterClause().Replace(match.Groups[1].Value, "").Split(','))
            {
                names.Add(name.Trim().Split('[')[0]);
            }
        }
        return names;
    }

    /// <summary>Variables whose GetDimensions is called.</summary>
    public static HashSet<string> Sized(string text) => [.. GetDimensions().Matches(text).Select(m => m.Groups[1].Value)];

    [GeneratedRegex(@"\b(?:RW)?ByteAddressBuffer\s+((?:[^;(){}]|\([^()]*\))+);")]
    private static partial Regex RawBufferDeclaration();

    [GeneratedRegex(@":\s*register\s*\([^)]*\)")]
    private static partial Regex RegisterClause();

    [GeneratedRegex(@"\b(\w+)\s*\.\s*GetDimensions\s*\(")]
    private static partial Regex GetDimensions();
}
