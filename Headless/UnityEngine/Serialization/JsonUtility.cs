using System;
using System.Text.Json;
using Headless.Engine;

namespace UnityEngine;

/// <summary>Serialises the fields Unity serialises, by name.</summary>
public static class JsonUtility
{
    public static string ToJson(object obj) => ToJson(obj, false);
    public static string ToJson(object obj, bool prettyPrint) => obj is null ? "" : FieldJson.Write(obj, prettyPrint);
    public static T FromJson<T>(string json) => (T)FromJson(json, typeof(T))!;

    public static object FromJson(string json, Type type)
    {
        ArgumentNullException.ThrowIfNull(type);
        if (string.IsNullOrEmpty(json)) return null!;
        if (typeof(Object).IsAssignableFrom(type))
            throw new ArgumentException($"Cannot deserialize JSON to new instances of type '{type.Name}.' Use FromJsonOverwrite.");
        object instance = Activator.CreateInstance(type, nonPublic: true)!;
        FromJsonOverwrite(json, instance);
        return instance;
    }

    public static void FromJsonOverwrite(string json, object objectToOverwrite)
    {
        if (string.IsNullOrEmpty(json) || objectToOverwrite is null) return;
        JsonDocument document;
        try
        {
            document = JsonDocument.Parse(json);
        }
        catch (JsonException exception)
        {
            throw new ArgumentException("JSON parse error: " + exception.Message, exception);
        }
        using (document) FieldJson.Read(document.RootElement, objectToOverwrite);
    }
}
