using System.Globalization;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Headless.Importers.Yaml;

/// <summary>
/// Reads the multi-document YAML of .unity, .prefab, .asset and .mat files, and the single document of .meta files.
/// The document headers are read here, because <c>stripped</c> after the anchor is Unity's own and not YAML;
/// each body is read from YamlDotNet's parser events.
/// </summary>
public static class UnityYaml
{
    private const string Header = "--- !u!";

    public static List<UnityDocument> ReadDocuments(string path)
    {
        string text = File.ReadAllText(path);
        if (!text.StartsWith("%YAML", StringComparison.Ordinal))
            throw new ImportException($"{path}: not a Unity text file (no %YAML line). In the Editor set Project Settings > Editor > Asset Serialization to Force Text and save it again.");
        return ParseDocuments(text, path);
    }

    public static List<UnityDocument> ParseDocuments(string text, string path)
    {
        var documents = new List<UnityDocument>();
        var seen = new HashSet<long>();
        int line = 1, start = 0;
        (int ClassId, long FileId, bool Stripped, int Line)? current = null;
        int bodyStart = 0, bodyLine = 1;
        while (start <= text.Length)
        {
            int end = text.IndexOf('\n', start);
            bool last = end < 0;
            if (last) end = text.Length;
            bool isHeader = string.CompareOrdinal(text, start, Header, 0, Header.Length) == 0;
            if (current is { } open && (isHeader || last))
            {
                int stop = last && !isHeader ? text.Length : start;
                documents.Add(ParseBody(text[bodyStart..stop], open, path, bodyLine));
                current = null;
            }
            if (isHeader)
            {
                current = ParseHeader(text[start..end].TrimEnd('\r'), path, line);
                if (!seen.Add(current.Value.FileId))
                    throw new ImportException($"{path}:{line}: fileID {current.Value.FileId} is used twice in this file.");
                bodyStart = last ? end : end + 1;
                bodyLine = line + 1;
            }
            if (last) break;
            start = end + 1;
            line++;
        }
        return documents;
    }

    public static YamlMap ParseMap(string text, string path, int firstLine = 1)
    {
        try
        {
            var parser = new Parser(new StringReader(text));
            parser.Consume<StreamStart>();
            if (parser.Accept<StreamEnd>(out _)) return new YamlMap();
            parser.Consume<DocumentStart>();
            return ReadNode(parser, path, firstLine) as YamlMap
                ?? throw new ImportException($"{path}:{firstLine}: a mapping was expected.");
        }
        catch (YamlException e)
        {
            throw new ImportException($"{path}:{firstLine + e.Start.Line - 1}: not readable as YAML: {e.Message}", e);
        }
        catch (InvalidOperationException e)
        {
            // YamlDotNet's scanner on a flow mapping that is not closed.
            throw new ImportException($"{path}: the object at line {firstLine - 1} is not readable as YAML.", e);
        }
    }

    private static (int, long, bool, int) ParseHeader(string header, string path, int line)
    {
        string[] words = header[Header.Length..].Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words.Length >= 2 && words[1].StartsWith('&')
            && int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int classId)
            && long.TryParse(words[1].AsSpan(1), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
            return (classId, fileId, words.Length > 2 && words[2] == "stripped", line);
        throw new ImportException($"{path}:{line}: '{header}' is not an object header (--- !u!<class id> &<file id>).");
    }

    private static UnityDocument ParseBody(string body, (int ClassId, long FileId, bool Stripped, int Line) header, string path, int bodyLine)
    {
        YamlMap outer = ParseMap(body, path, bodyLine);
        if (outer.Count == 0) throw new ImportException($"{path}:{header.Line}: the object has no body.");
        var (name, value) = outer.Entries[0];
        return new UnityDocument(header.ClassId, header.FileId, header.Stripped, name, value as YamlMap ?? new YamlMap(), header.Line);
    }

    private static YamlNode ReadNode(IParser parser, string path, int firstLine)
    {
        if (parser.TryConsume<Scalar>(out var scalar)) return new YamlScalar(scalar.Value);
        if (parser.TryConsume<SequenceStart>(out _))
        {
            var list = new YamlList();
            while (!parser.TryConsume<SequenceEnd>(out _)) list.Items.Add(ReadNode(parser, path, firstLine));
            return list;
        }
        if (parser.TryConsume<MappingStart>(out _))
        {
            var map = new YamlMap();
            while (!parser.TryConsume<MappingEnd>(out _))
                map.Set(parser.Consume<Scalar>().Value, ReadNode(parser, path, firstLine));
            return map;
        }
        ParsingEvent? unexpected = parser.Current;
        throw new ImportException($"{path}:{firstLine + (unexpected?.Start.Line ?? 1) - 1}: unexpected YAML ({unexpected?.GetType().Name}); Unity reads scalars, mappings and sequences only.");
    }
}
