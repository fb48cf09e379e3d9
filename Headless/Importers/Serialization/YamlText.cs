using System.Globalization;
using System.Text.Json;
using UnityEngine;

namespace Headless.Importers.Serialization;

/// <summary>Values as Unity's text files have them.</summary>
internal static class YamlText
{
    public static string Of(float value) => value.ToString("R", CultureInfo.InvariantCulture);
    public static string Of(double value) => value.ToString("R", CultureInfo.InvariantCulture);
    public static string Of(Vector2 v) => $"{{x: {Of(v.x)}, y: {Of(v.y)}}}";
    public static string Of(Vector3 v) => $"{{x: {Of(v.x)}, y: {Of(v.y)}, z: {Of(v.z)}}}";
    public static string Of(Quaternion q) => $"{{x: {Of(q.x)}, y: {Of(q.y)}, z: {Of(q.z)}, w: {Of(q.w)}}}";
    public static string Of(Color c) => $"{{r: {Of(c.r)}, g: {Of(c.g)}, b: {Of(c.b)}, a: {Of(c.a)}}}";

    /// <summary>Plain where no reader could take it for something else.</summary>
    public static string Of(string value) =>
        value.Length > 0 && char.IsAsciiLetter(value[0]) && value.All(c => char.IsAsciiLetterOrDigit(c) || c is ' ' or '_' or '(' or ')' or '.') && value[^1] != ' '
            ? value : value.Length == 0 ? "" : JsonSerializer.Serialize(value);

    /// <summary>Null for a type that is not written on one line.</summary>
    public static string? Of(object? value) => value switch
    {
        bool b => b ? "1" : "0",
        float f => Of(f),
        double d => Of(d),
        string s => Of(s),
        PropertyName n => Of(n.Name),
        char c => ((int)c).ToString(CultureInfo.InvariantCulture),
        Enum e => Convert.ToInt64(e, CultureInfo.InvariantCulture).ToString(CultureInfo.InvariantCulture),
        Vector2 v => Of(v),
        Vector3 v => Of(v),
        Vector4 v => $"{{x: {Of(v.x)}, y: {Of(v.y)}, z: {Of(v.z)}, w: {Of(v.w)}}}",
        Vector2Int v => Invariant($"{{x: {v.x}, y: {v.y}}}"),
        Vector3Int v => Invariant($"{{x: {v.x}, y: {v.y}, z: {v.z}}}"),
        Quaternion q => Of(q),
        Color c => Of(c),
        IConvertible n => Convert.ToString(n, CultureInfo.InvariantCulture),
        _ => null,
    };

    public static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
