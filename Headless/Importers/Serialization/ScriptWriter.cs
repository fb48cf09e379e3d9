using System.Collections;
using System.Text;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Importers.Serialization;

/// <summary>Writes the fields of a script object, those that <see cref="ScriptReader"/> reads.</summary>
internal sealed class ScriptWriter(StringBuilder text, Func<Object?, string> reference)
{
    public void Write(object target, int indent)
    {
        (target as ISerializationCallbackReceiver)?.OnBeforeSerialize();
        foreach (SerializedField field in SerializationRules.FieldsOf(target.GetType()))
        {
            if (field.ByReference) throw new NotSupportedException($"{target.GetType().Name}.{field.Field.Name} has [SerializeReference]; it cannot be saved here.");
            Field(field.Field.Name, field.Field.FieldType, field.Field.GetValue(target), indent);
        }
    }

    private void Field(string name, Type type, object? value, int indent)
    {
        if (SerializationRules.ElementType(type) is { } element)
        {
            object?[] items = value is IEnumerable list ? [.. list.Cast<object?>()] : [];
            Line(indent, items.Length == 0 ? $"{name}: []" : $"{name}:");
            foreach (object? item in items) Element(element, item, indent);
        }
        else if (Inline(type, value) is { } inline)
        {
            Line(indent, $"{name}: {inline}");
        }
        else
        {
            Line(indent, $"{name}:");
            Nested(type, value, indent + 1);
        }
    }

    private void Element(Type type, object? value, int indent)
    {
        if (Inline(type, value) is { } inline)
        {
            Line(indent, $"- {inline}");
            return;
        }
        int begin = text.Length;
        Nested(type, value, indent + 1);
        if (text.Length > begin) text[begin + 2 * indent] = '-'; // before the first field
        else Line(indent, "- {}");
    }

    private string? Inline(Type type, object? value)
    {
        if (typeof(Object).IsAssignableFrom(type)) return reference((Object?)value);
        return type == typeof(string) && value is null ? "" : YamlText.Of(value);
    }

    private void Nested(Type type, object? value, int indent)
    {
        switch (value)
        {
            case LayerMask mask:
                Line(indent, "serializedVersion: 2");
                Line(indent, YamlText.Invariant($"m_Bits: {(uint)mask.value}"));
                break;
            case null:
                break;
            default:
                if (ValueReaders.Knows(type)) throw new NotSupportedException($"Values of {type.Name} cannot be saved here.");
                Write(value, indent);
                break;
        }
    }

    private void Line(int indent, string line) => text.Append(' ', 2 * indent).Append(line).Append('\n');
}
