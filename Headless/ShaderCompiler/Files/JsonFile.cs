using System.Text.Json;

namespace Headless.Files;

/// <summary>Small JSON files of a project: package.json, manifest.json, .asmdef. Whatever else they hold, the root is an object.</summary>
public static class JsonFile
{
    private const int LargestFile = 16 << 20;

    /// <exception cref="BadFileException">The file cannot be read or holds no JSON object.</exception>
    public static JsonDocument Read(string path)
    {
        try
        {
            JsonDocument document = JsonDocument.Parse(BoundedText.ReadAll(path, LargestFile));
            if (document.RootElement.ValueKind == JsonValueKind.Object) return document;
            document.Dispose();
        }
        catch (JsonException e)
        {
            throw new BadFileException($"{path}:{(e.LineNumber ?? 0) + 1}: not valid JSON: {e.Message} Correct the line, or restore the file from version control.", e);
        }
        throw new BadFileException($"{path}: a JSON object was expected. Restore the file from version control.");
    }

    /// <summary>A text member of the root; null when it is missing.</summary>
    /// <exception cref="BadFileException">The member is no text.</exception>
    public static string? Text(JsonDocument json, string key, string path)
    {
        if (!json.RootElement.TryGetProperty(key, out JsonElement value)) return null;
        return value.ValueKind == JsonValueKind.String
            ? value.GetString()
            : throw new BadFileException($"{path}: \"{key}\" must be a text, found '{OneLine.Value(value.GetRawText())}'. Put it in double quotes.");
    }
}
