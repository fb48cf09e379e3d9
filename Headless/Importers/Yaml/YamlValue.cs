using System.Globalization;

namespace Headless.Importers.Yaml;

/// <summary>Numbers as the Editor writes them: <c>0.33333334</c>, <c>3.4028235e+38</c>, <c>Infinity</c>, <c>-0</c>, booleans as 0 and 1.</summary>
public static class YamlValue
{
    public static float Float(string text, string key)
    {
        switch (text)
        {
            case "Infinity" or "inf" or ".inf": return float.PositiveInfinity;
            case "-Infinity" or "-inf" or "-.inf": return float.NegativeInfinity;
            case "NaN" or "nan" or ".nan" or "-nan": return float.NaN;
        }
        return float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value)
            ? value
            : throw new FormatException($"'{key}' must be a number, found '{text}'.");
    }

    public static double Double(string text, string key) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? value : Float(text, key);

    public static long Long(string text, string key)
    {
        if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value)) return value;
        if (ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong big)) return unchecked((long)big);
        throw new FormatException($"'{key}' must be an integer, found '{text}'.");
    }

    public static bool Bool(string text, string key) => text switch
    {
        "1" or "true" or "True" => true,
        "0" or "false" or "False" => false,
        _ => Long(text, key) != 0,
    };
}
