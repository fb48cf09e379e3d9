using System;
using System.Globalization;
using System.Text;

namespace UnityEngine;

/// <summary>The text form shared by the value types: parenthesised, comma separated, two decimals unless a format is given.</summary>
static class Formatting
{
    public static string Tuple(string? format, IFormatProvider? provider, params ReadOnlySpan<float> values)
    {
        if (string.IsNullOrEmpty(format)) format = "F2";
        provider ??= CultureInfo.InvariantCulture.NumberFormat;
        var text = new StringBuilder("(");
        for (int i = 0; i < values.Length; i++)
        {
            if (i > 0) text.Append(", ");
            text.Append(values[i].ToString(format, provider));
        }
        return text.Append(')').ToString();
    }

    public static string Tuple(string? format, IFormatProvider? provider, params ReadOnlySpan<int> values)
    {
        provider ??= CultureInfo.InvariantCulture.NumberFormat;
        var text = new StringBuilder("(");
        for (int i = 0; i < values.Length; i++)
        {
            if (i > 0) text.Append(", ");
            text.Append(values[i].ToString(format, provider));
        }
        return text.Append(')').ToString();
    }
}
