using System.Globalization;

namespace Headless.Mutation;

/// <summary>Another value for a number in HLSL or C#, in the same spelling.</summary>
internal static class Constants
{
    private const double Tiny = 1e-3;

    /// <summary>
    /// 0 becomes 1, a whole number n + 1, a fraction ten percent more. A tiny number is a guard, of which ten percent mean
    /// nothing: it becomes 0. Null where the text is no number.
    /// </summary>
    public static string? Other(string text)
    {
        int end = text.Length;
        while (end > 0 && char.IsLetter(text[end - 1]) && !IsHex(text)) end--;
        if (IsHex(text) && text[^1] is 'u' or 'U' or 'l' or 'L') end = text.Length - 1;
        (string digits, string suffix) = (text[..end], text[end..]);
        if (IsHex(digits))
            return ulong.TryParse(digits.AsSpan(2), NumberStyles.HexNumber, CultureInfo.InvariantCulture, out ulong bits) ? $"0x{bits ^ 1:x}{suffix}" : null;
        if (ulong.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out ulong whole) && suffix is not ("f" or "d" or "h" or "F"))
            return (whole + 1).ToString(CultureInfo.InvariantCulture) + suffix;
        if (!double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)) return null;
        double other = value == 0.0 ? 1.0 : Math.Abs(value) < Tiny ? 0.0 : value * 1.1;
        string written = other.ToString("R", CultureInfo.InvariantCulture);
        if (suffix.Length > 0 || written.Contains('.') || written.Contains('E')) return Shorten(other) + suffix;
        return written + ".0";
    }

    private static string Shorten(double value)
    {
        string text = value.ToString("G7", CultureInfo.InvariantCulture);
        return text.Contains('.') || text.Contains('E') ? text : text + ".0";
    }

    private static bool IsHex(string text) => text.StartsWith("0x", StringComparison.OrdinalIgnoreCase);
}
