using System;
using System.Buffers;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>JSON of serialised fields; object references are written as their instance id.</summary>
static class FieldJson
{
    public static string Write(object value, bool pretty)
    {
        if (value is ISerializationCallbackReceiver receiver) receiver.OnBeforeSerialize();
        var buffer = new ArrayBufferWriter<byte>();
        using (var writer = new Utf8JsonWriter(buffer, new JsonWriterOptions { Indented = pretty, IndentSize = 4, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
            WriteFields(writer, value);
        return Encoding.UTF8.GetString(buffer.WrittenSpan);
    }

    static void WriteFields(Utf8JsonWriter writer, object value)
    {
        writer.WriteStartObject();
        foreach (FieldInfo field in Fields(value.GetType()))
        {
            writer.WritePropertyName(field.Name);
            WriteValue(writer, field.GetValue(value), field.FieldType);
        }
        writer.WriteEndObject();
    }

    // Engine values keep their state in private fields (Bounds, Rect): all instance fields count for them.
    static FieldInfo[] Fields(Type type) => SerializedFields.IsEngineValue(type)
        ? type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
        : SerializedFields.Of(type);

    static void WriteValue(Utf8JsonWriter writer, object? value, Type type)
    {
        switch (value)
        {
            case null when type == typeof(string): writer.WriteStringValue(""); return;
            case null when SerializedFields.ElementType(type) is not null: writer.WriteStartArray(); writer.WriteEndArray(); return;
            case null when typeof(Object).IsAssignableFrom(type): WriteReference(writer, 0); return;
            case null: WriteFields(writer, Activator.CreateInstance(type, nonPublic: true)!); return;
            case Object reference: WriteReference(writer, reference.GetInstanceID()); return;
            case string text: writer.WriteStringValue(text); return;
            case bool flag: writer.WriteBooleanValue(flag); return;
            case char letter: writer.WriteNumberValue(letter); return;
            case float number: WriteFloat(writer, number, number.ToString("R", System.Globalization.CultureInfo.InvariantCulture)); return;
            case double number: WriteFloat(writer, number, number.ToString("R", System.Globalization.CultureInfo.InvariantCulture)); return;
            case Enum choice: writer.WriteNumberValue(Convert.ToInt64(choice)); return;
            case ulong number: writer.WriteNumberValue(number); return;
            case IConvertible number: writer.WriteNumberValue(Convert.ToInt64(number)); return;
            case IEnumerable list:
                Type element = SerializedFields.ElementType(type)!;
                writer.WriteStartArray();
                foreach (object? item in list) WriteValue(writer, item, element);
                writer.WriteEndArray();
                return;
            default: WriteFields(writer, value); return;
        }
    }

    static void WriteFloat(Utf8JsonWriter writer, double value, string text)
    {
        if (double.IsFinite(value)) writer.WriteRawValue(text.Contains('E') || text.Contains('.') ? text : text + ".0");
        else writer.WriteStringValue(text);
    }

    static void WriteReference(Utf8JsonWriter writer, int id)
    {
        writer.WriteStartObject();
        writer.WriteNumber("instanceID", id);
        writer.WriteEndObject();
    }

    public static void Read(JsonElement json, object target)
    {
        ReadFields(json, target);
        if (target is ISerializationCallbackReceiver receiver) receiver.OnAfterDeserialize();
    }

    static void ReadFields(JsonElement json, object target)
    {
        if (json.ValueKind != JsonValueKind.Object) throw new ArgumentException("JSON must represent an object type.");
        foreach (FieldInfo field in Fields(target.GetType()))
            if (json.TryGetProperty(field.Name, out JsonElement value)) field.SetValue(target, ReadValue(value, field.FieldType, field.GetValue(target)));
    }

    static object? ReadValue(JsonElement json, Type type, object? current)
    {
        if (type == typeof(string)) return json.ValueKind == JsonValueKind.String ? json.GetString() : json.ToString();
        if (type == typeof(bool)) return json.ValueKind == JsonValueKind.Number ? json.GetDouble() != 0 : json.GetBoolean();
        if (type == typeof(float)) return (float)ReadNumber(json);
        if (type == typeof(double)) return ReadNumber(json);
        if (type.IsEnum) return Enum.ToObject(type, json.GetInt64());
        if (type == typeof(ulong)) return json.GetUInt64();
        if (type == typeof(char)) return (char)json.GetInt32();
        if (type.IsPrimitive) return Convert.ChangeType(json.GetInt64(), type);
        if (typeof(Object).IsAssignableFrom(type))
            return json.TryGetProperty("instanceID", out JsonElement id) ? ObjectRegistry.Find(id.GetInt32()) : current;
        if (SerializedFields.ElementType(type) is { } element) return ReadList(json, type, element);
        object instance = current ?? Activator.CreateInstance(type, nonPublic: true)!;
        ReadFields(json, instance);
        return instance;
    }

    static double ReadNumber(JsonElement json) =>
        json.ValueKind == JsonValueKind.String ? double.Parse(json.GetString()!, System.Globalization.CultureInfo.InvariantCulture) : json.GetDouble();

    static object ReadList(JsonElement json, Type type, Type element)
    {
        var items = new List<object?>();
        foreach (JsonElement item in json.EnumerateArray()) items.Add(ReadValue(item, element, null));
        if (type.IsArray)
        {
            Array array = Array.CreateInstance(element, items.Count);
            for (int i = 0; i < items.Count; i++) array.SetValue(items[i], i);
            return array;
        }
        var list = (IList)Activator.CreateInstance(type)!;
        foreach (object? item in items) list.Add(item);
        return list;
    }
}
