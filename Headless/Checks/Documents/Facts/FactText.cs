using System.Globalization;

namespace Headless.Checks.Documents.Facts;

/// <summary>Numbers and lists as documents write them.</summary>
internal static class FactText
{
    private const string Raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    /// <summary>16384 is 16,384; 0.75 is 0.75.</summary>
    public static string Number(double value) =>
        value == Math.Floor(value) && Math.Abs(value) < 1e15 ? value.ToString("#,0", CultureInfo.InvariantCulture) : value.ToString("G6", CultureInfo.InvariantCulture);

    /// <summary>0.037 is 3.7·10⁻².</summary>
    public static string Scientific(double value)
    {
        var exponent = (int)Math.Floor(Math.Log10(Math.Abs(value)));
        var digits = string.Concat(Math.Abs(exponent).ToString(CultureInfo.InvariantCulture).Select(c => Raised[c - '0']));
        return $"{(value / Math.Pow(10, exponent)).ToString("G4", CultureInfo.InvariantCulture)}·10{(exponent < 0 ? "⁻" : "")}{digits}";
    }

    /// <summary>a; a and b; a, b and c.</summary>
    public static string List(IReadOnlyList<string> words, string last = "and") =>
        words.Count < 2 ? string.Concat(words) : $"{string.Join(", ", words.SkipLast(1))} {last} {words[^1]}";

    /// <summary>2026-11-25 and 2026-11-26 are 2026-11-25 and 26.</summary>
    public static string Dates(IEnumerable<string> dates)
    {
        var days = dates.Distinct().Order(StringComparer.Ordinal).ToList();
        return List([.. days.Select((day, i) => i > 0 && day[..8] == days[0][..8] ? day[8..] : day)]);
    }

    /// <summary>llvmpipe (LLVM 15.0.6, 256 bits) is llvmpipe (CPU).</summary>
    public static string Device(string device) => device.StartsWith("llvmpipe", StringComparison.Ordinal) ? "llvmpipe (CPU)" : device;
}
