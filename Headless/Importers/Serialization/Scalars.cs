using Headless.Importers.Yaml;

namespace Headless.Importers.Serialization;

/// <summary>Text to the primitive types, enums and strings of script fields.</summary>
public static class Scalars
{
    /// <param name="name">Name of the field, for messages.</param>
    /// <exception cref="ImportException">The text is no value of the type.</exception>
    public static object Read(YamlScalar scalar, Type type, string name)
    {
        if (type == typeof(string)) return scalar.Text;
        if (type == typeof(float)) return scalar.IsEmpty ? 0f : YamlValue.Float(scalar, name);
        if (type == typeof(double)) return scalar.IsEmpty ? 0d : YamlValue.Double(scalar, name);
        if (type == typeof(bool)) return !scalar.IsEmpty && YamlValue.Bool(scalar, name);
        long value = scalar.IsEmpty ? 0 : Integer(scalar, name);
        return FromLong(value, type, type.IsEnum ? Enum.GetUnderlyingType(type) : type);
    }

    /// <summary>A field that was a float may hold <c>2.5</c> when it is an integer now: Unity cuts it.</summary>
    private static long Integer(YamlScalar scalar, string name)
    {
        if (scalar.Text.AsSpan().IndexOfAny('.', 'e', 'E') < 0) return YamlValue.Long(scalar, name);
        double value = YamlValue.Double(scalar, name);
        return Math.Abs(value) <= long.MaxValue / 2 ? (long)value : throw YamlValue.Wrong(scalar, name, "a whole number of at most 64 bits");
    }

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
