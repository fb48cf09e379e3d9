using Headless.Files;
using Headless.Importers.Yaml;

namespace Headless.Importers.Project;

/// <summary>A .meta file: the asset's GUID and its import settings.</summary>
public sealed class MetaFile
{
    private const int LargestFile = 16 << 20;

    private MetaFile(string path, string guid, string importer, YamlMap settings)
    {
        Path = path;
        Guid = guid;
        Importer = importer;
        Settings = settings;
    }

    public string Path { get; }
    public string Guid { get; }

    /// <summary>ModelImporter, TextureImporter, ...; empty in the two-line form that Unity 6 writes for new scripts.</summary>
    public string Importer { get; }
    public YamlMap Settings { get; }

    public static MetaFile Read(string path)
    {
        YamlMap map = UnityYaml.ParseMap(BoundedText.ReadAll(path, LargestFile), path);
        string guid = map.Text("guid");
        if (!IsGuid(guid))
            throw new ImportException($"{map["guid"]?.Place ?? map.Place}: 'guid: {OneLine.Value(guid)}' is not 32 lower-case hexadecimal digits. Delete the .meta file and let the Editor write a new one, or restore it from version control.");
        foreach (var (key, value) in map.Entries)
            if (value is YamlMap settings && key.EndsWith("Importer", StringComparison.Ordinal))
                return new MetaFile(path, guid, key, settings);
        return new MetaFile(path, guid, "", new YamlMap());
    }

    public static bool IsGuid(string text) => text.Length == 32 && text.All(c => c is >= '0' and <= '9' or >= 'a' and <= 'f');

    /// <summary>Reads the GUID line only: metas of large folders are indexed without parsing them whole.</summary>
    internal static string ReadGuid(string path)
    {
        foreach (string line in BoundedText.ReadAll(path, LargestFile).Split('\n', 9).Take(8))
            if (line.StartsWith("guid:", StringComparison.Ordinal) && IsGuid(line[5..].Trim()))
                return line[5..].Trim();
        return Read(path).Guid;
    }
}
