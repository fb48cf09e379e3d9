using System.Globalization;
using System.Runtime.InteropServices;
using Headless.Importers.Yaml;

namespace Headless.Importers.Serialization;

/// <summary>Arrays of integers, booleans and enums are one little-endian hexadecimal string: int[] {1, 7} is <c>0100000007000000</c>.</summary>
public static class PackedArray
{
    /// <param name="name">Name of the field, for messages.</param>
    /// <exception cref="ImportException">The text is no packed array.</exception>
    public static Array Read(YamlScalar packed, Type element, string name)
    {
        Type stored = element.IsEnum ? Enum.GetUnderlyingType(element) : element;
        int size = stored == typeof(bool) ? 1 : stored == typeof(char) ? 2 : Marshal.SizeOf(stored);
        string hex = packed.Text.Trim();
        if (hex.Length % (2 * size) != 0 || !hex.All(char.IsAsciiHexDigit))
            throw YamlValue.Wrong(packed, name, $"a packed array of {element.Name} ({2 * size} hexadecimal digits each)");
        byte[] bytes = Convert.FromHexString(hex);
        int count = bytes.Length / size;
        Array result = Array.CreateInstance(element, count);
        for (int i = 0; i < count; i++) result.SetValue(Element(bytes.AsSpan(i * size, size), element, stored), i);
        return result;
    }

    private static object Element(ReadOnlySpan<byte> bytes, Type element, Type stored)
    {
        long value = 0;
        for (int i = bytes.Length - 1; i >= 0; i--) value = value << 8 | bytes[i];
        return Scalars.FromLong(value, element, stored);
    }
}
