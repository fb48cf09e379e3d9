using System.Globalization;
using Headless.Files;
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

    /// <summary>Unity nests serialised classes ten deep at most; each adds a mapping, in lists two levels.</summary>
    private const int DeepestNesting = 64;

    /// <summary>Values in a file: some 400 MB in memory.</summary>
    public const int MostValues = 2_000_000;

    public static List<UnityDocument> ReadDocuments(string path)
    {
        string text = BoundedText.ReadAll(path);
        if (!text.StartsWith("%YAML", StringComparison.Ordinal))
            throw new ImportException($"{path}: not a Unity text file (no %YAML line). In the Editor set Project Settings > Editor > Asset Serialization to Force Text and save it again.");
        return ParseDocuments(text, path);
    }

    public static List<UnityDocument> ParseDocuments(string text, string path)
    {
        var documents = new List<UnityDocument>();
        var seen = new HashSet<long>();
        var reader = new NodeReader(path);
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
                documents.Add(ParseBody(text[bodyStart..stop], open, path, bodyLine, reader));
                current = null;
            }
            if (isHeader)
            {
                current = ParseHeader(text[start..end].TrimEnd('\r'), path, line);
                if (!seen.Add(current.Value.FileId))
                    throw new ImportException($"{path}:{line}: fileID {current.Value.FileId} is used twice in this file. Give one of the objects another id, or restore the file from version control.");
                bodyStart = last ? end : end + 1;
                bodyLine = line + 1;
            }
            if (last) break;
            start = end + 1;
            line++;
        }
        if (current is { } unread) throw NoBody(path, unread.Line);
        if (documents.Count == 0)
            throw ImportException.At(path, "the file holds no object (no line that begins with --- !u!).", "Restore it from version control, or save it again in the Editor.");
        return documents;
    }

    public static YamlMap ParseMap(string text, string path, int firstLine = 1) => ParseMap(text, new NodeReader(path), firstLine);

    private static YamlMap ParseMap(string text, NodeReader reader, int firstLine)
    {
        try
        {
            return reader.Read(text, firstLine);
        }
        catch (YamlException e)
        {
            throw ImportException.At(reader.At(e.Start.Line), $"not readable as YAML: {OneLine.Value(e.Message)}.", inner: e);
        }
        catch (Exception e) when (e is not ImportException)
        {
            // YamlDotNet's scanner has faults of its own, as on a flow mapping that is not closed.
            throw ImportException.At(reader.At(reader.Line), "not readable as YAML from here on.", inner: e);
        }
    }

    private static (int, long, bool, int) ParseHeader(string header, string path, int line)
    {
        string[] words = header[Header.Length..].Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words.Length >= 2 && words[1].StartsWith('&')
            && int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int classId)
            && long.TryParse(words[1].AsSpan(1), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
            return (classId, fileId, words.Length > 2 && words[2] == "stripped", line);
        throw new ImportException($"{path}:{line}: '{OneLine.Value(header)}' is not an object header (--- !u!<class id> &<file id>). Restore the file from version control.");
    }

    private static UnityDocument ParseBody(string body, (int ClassId, long FileId, bool Stripped, int Line) header, string path, int bodyLine,
        NodeReader reader)
    {
        YamlMap outer = ParseMap(body, reader, bodyLine);
        if (outer.Count == 0) throw NoBody(path, header.Line);
        if (outer.Count > 1)
            throw ImportException.At(outer.Entries[1].Value.Place.ToString(), $"'{OneLine.Value(outer.Entries[1].Key)}' stands outside of the object.");
        var (name, value) = outer.Entries[0];
        return new UnityDocument(header.ClassId, header.FileId, header.Stripped, name, BodyOf(name, value), header.Line);
    }

    private static ImportException NoBody(string path, int line) =>
        ImportException.At(new YamlPlace(path, line).ToString(), "the object has no body.", "Remove its header, or restore the file from version control.");

    private static YamlMap BodyOf(string name, YamlNode value) => value switch
    {
        YamlMap map => map,
        YamlScalar { IsEmpty: true } => new YamlMap(value.Place),
        _ => throw ImportException.At(value.Place.ToString(), $"the fields of '{OneLine.Value(name)}' must be a mapping, found {value.Kind}."),
    };

    /// <summary>Turns the parser's events into nodes, with bounds on depth and number.</summary>
    private sealed class NodeReader(string path)
    {
        private readonly Dictionary<string, string> keys = [];
        private int firstLine, values;

        public long Line { get; private set; } = 1;

        public string At(long line) => new YamlPlace(path, (int)(firstLine + line - 1)).ToString();

        public YamlMap Read(string text, int startsAt)
        {
            (firstLine, Line) = (startsAt, 1);
            var parser = new Parser(new StringReader(text));
            parser.Consume<StreamStart>();
            if (parser.Accept<StreamEnd>(out _)) return new YamlMap(new YamlPlace(path, firstLine));
            parser.Consume<DocumentStart>();
            YamlNode root = ReadNode(parser, 1);
            parser.Consume<DocumentEnd>();
            if (!parser.Accept<StreamEnd>(out _))
                throw ImportException.At(At(parser.Current?.Start.Line ?? Line), "a line --- that is no object header (--- !u!<class id> &<file id>).");
            return root as YamlMap ?? throw ImportException.At(root.Place.ToString(), $"a mapping was expected, found {root.Kind}.");
        }

        private YamlNode ReadNode(Parser parser, int depth)
        {
            Line = parser.Current?.Start.Line ?? Line;
            var place = new YamlPlace(path, (int)(firstLine + Line - 1));
            if (++values > MostValues)
                throw ImportException.At(place.ToString(), $"more than {MostValues} values in one file.", "Move large data into assets of their own.");
            if (parser.TryConsume<Scalar>(out var scalar)) return new YamlScalar(scalar.Value, place);
            if (depth > DeepestNesting)
                throw ImportException.At(place.ToString(), $"values are nested more than {DeepestNesting} deep, which Unity never writes.");
            if (parser.TryConsume<SequenceStart>(out _))
            {
                var list = new YamlList(place);
                while (!parser.TryConsume<SequenceEnd>(out _)) list.Items.Add(ReadNode(parser, depth + 1));
                return list;
            }
            if (parser.TryConsume<MappingStart>(out _))
            {
                var map = new YamlMap(place);
                while (!parser.TryConsume<MappingEnd>(out _)) map.Set(Key(parser), ReadNode(parser, depth + 1));
                return map;
            }
            throw ImportException.At(place.ToString(),
                $"unexpected YAML ({parser.Current?.GetType().Name}); Unity reads scalars, mappings and sequences only.");
        }

        /// <summary>Field names repeat from object to object: one string each.</summary>
        private string Key(Parser parser)
        {
            string key = parser.Consume<Scalar>().Value;
            if (keys.TryGetValue(key, out string? known)) return known;
            keys[key] = key;
            return key;
        }
    }
}
