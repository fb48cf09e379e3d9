using System.Text.Json;
using System.Text.Json.Nodes;

namespace Headless.Player.Output;

/// <summary><c>summary.json</c>: keys in the order given; a list of texts by key becomes an object.</summary>
public static class SummaryFile
{
    public const string FileName = "summary.json";

    /// <summary>Changes one number of a file that others have added to since; a file that is gone stays gone.</summary>
    public static void Change(string path, string key, int value)
    {
        if (!File.Exists(path) || JsonNode.Parse(File.ReadAllText(path)) is not JsonObject all) return;
        all[key] = value;
        WholeFile.WriteText(path, all.ToJsonString(Indented) + "\n");
    }

    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true };

    public static void Write(string path, IReadOnlyList<(string Key, object? Value)> entries) => WholeFile.Write(path, stream =>
    {
        using var writer = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        writer.WriteStartObject();
        foreach (var (key, value) in entries)
        {
            writer.WritePropertyName(key);
            switch (value)
            {
                case null: writer.WriteNullValue(); break;
                case bool b: writer.WriteBooleanValue(b); break;
                case int i: writer.WriteNumberValue(i); break;
                case long l: writer.WriteNumberValue(l); break;
                case double d when double.IsFinite(d): writer.WriteNumberValue(Math.Round(d, 6)); break;
                case double: writer.WriteNullValue(); break;
                case IReadOnlyList<(string Key, string Text)> texts:
                    writer.WriteStartObject();
                    foreach (var (name, text) in texts) writer.WriteString(name, text);
                    writer.WriteEndObject();
                    break;
                default: writer.WriteStringValue(value.ToString()); break;
            }
        }
        writer.WriteEndObject();
    });
}
