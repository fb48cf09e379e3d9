using System.Globalization;
using Headless.Files;

namespace Headless.Importers.Yaml;

/// <summary>
/// Numbers as the Editor writes them: <c>0.33333334</c>, <c>3.4028235e+38</c>, <c>Infinity</c>, <c>-0</c>, booleans as 0 and 1.
/// The only place that reads a number of a Unity file: digits of the invariant culture, no <c>0x10</c>, no <c>1_000</c>.
/// </summary>
public static class YamlValue
{
    public static float Float(YamlScalar scalar, string key)
    {
        if (NotFinite(scalar.Text) is { } special) return (float)special;
        return float.TryParse(scalar.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && float.IsFinite(value)
            ? value
            : throw Wrong(scalar, key, "a number");
    }

    public static double Double(YamlScalar scalar, string key)
    {
        if (NotFinite(scalar.Text) is { } special) return special;
        return double.TryParse(scalar.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value)
            ? value
            : throw Wrong(scalar, key, "a number");
    }

    /// <summary>64 bits, signed or not.</summary>
    public static long Long(YamlScalar scalar, string key)
    {
        if (long.TryParse(scalar.Text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value)) return value;
        if (ulong.TryParse(scalar.Text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong big)) return unchecked((long)big);
        throw Wrong(scalar, key, "a whole number of at most 64 bits");
    }

    /// <summary>32 bits, signed or not: the Editor writes masks without sign.</summary>
    public static int Int(YamlScalar scalar, string key)
    {
        long value = Long(scalar, key);
        return value is >= int.MinValue and <= uint.MaxValue ? unchecked((int)value) : throw Wrong(scalar, key, "a whole number of at most 32 bits");
    }

    public static bool Bool(YamlScalar scalar, string key) => scalar.Text switch
    {
        "1" or "true" or "True" => true,
        "0" or "false" or "False" => false,
        _ => Long(scalar, key) != 0,
    };

    public static ImportException Wrong(YamlScalar scalar, string key, string expected) =>
        ImportException.At(scalar.Place.ToString(), $"'{OneLine.Value(key)}' must be {expected}, found '{OneLine.Value(scalar.Text)}'.");

    private static double? NotFinite(string text) => text switch
    {
        "Infinity" or "inf" or ".inf" => double.PositiveInfinity,
        "-Infinity" or "-inf" or "-.inf" => double.NegativeInfinity,
        "NaN" or "nan" or ".nan" or "-nan" => double.NaN,
        _ => null,
    };
}
