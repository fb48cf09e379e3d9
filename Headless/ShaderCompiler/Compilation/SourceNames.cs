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

    /// <summary>Numbers n of register(un) by the name they are given to.</summary>
    public static Dictionary<string, int> WriteRegisters(string text)
    {
        Dictionary<string, int> registers = [];
        foreach (Match match in WriteRegister().Matches(text))
        {
            registers[match.Groups[1].Value] = int.Parse(match.Groups[2].Value);
        }
        return registers;
    }

    [GeneratedRegex(@"\b(\w+)\s*(?:\[\w*\]\s*)?:\s*register\s*\(\s*u(\d+)")]
    private static partial Regex WriteRegister();

    [GeneratedRegex(@"\b(?:RW)?ByteAddressBuffer\s+((?:[^;(){}]|\([^()]*\))+);")]
    private static partial Regex RawBufferDeclaration();

    [GeneratedRegex(@":\s*register\s*\([^)]*\)")]
    private static partial Regex RegisterClause();

    [GeneratedRegex(@"\b(\w+)\s*\.\s*GetDimensions\s*\(")]
    private static partial Regex GetDimensions();
}
