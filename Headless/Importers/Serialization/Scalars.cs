using Headless.Importers.Yaml;

namespace Headless.Importers.Serialization;

/// <summary>Text to the primitive types, enums and strings of script fields.</summary>
public static class Scalars
{
    public static object Read(string text, Type type, string where)
    {
        if (type == typeof(string)) return text;
        if (type == typeof(float)) return text.Length == 0 ? 0f : YamlValue.Float(text, where);
        if (type == typeof(double)) return text.Length == 0 ? 0d : YamlValue.Double(text, where);
        if (type == typeof(bool)) return text.Length > 0 && YamlValue.Bool(text, where);
        long value = text.Length == 0 ? 0 : Integer(text, where);
        return FromLong(value, type, type.IsEnum ? Enum.GetUnderlyingType(type) : type);
    }

    /// <summary>A field that was a float may hold <c>2.5</c> when it is an integer now: Unity cuts it.</summary>
    private static long Integer(string text, string where) => text.AsSpan().IndexOfAny('.', 'e', 'E') >= 0 ? (long)YamlValue.Double(text, where) : YamlValue.Long(text, where);

    internal static object FromLong(long value, Type type, Type stored)
    {
        object number = unchecked(Type.GetTypeCode(stored) switch
        {
            TypeCode.Boolean => value != 0,
            TypeCode.Char => (char)value,
            TypeCode.SByte => (sbyte)value,
            TypeCode.Byte => (byte)value,
            TypeCode.Int16 => (short)value,
            TypeCode.UInt16 => (ushort)value,
            TypeCode.Int32 => (int)value,
            TypeCode.UInt32 => (uint)value,
            TypeCode.UInt64 => (ulong)value,
            TypeCode.Single => BitConverter.Int32BitsToSingle((int)value),
            TypeCode.Double => BitConverter.Int64BitsToDouble(value),
            _ => (object)value,
        });
        return type.IsEnum ? Enum.ToObject(type, number) : number;
    }
}
