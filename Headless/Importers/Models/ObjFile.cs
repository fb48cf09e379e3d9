using System.Globalization;
using System.Numerics;

namespace Headless.Importers.Models;

/// <summary>
/// A Wavefront .obj file as written: right-handed, polygons, 0-based indices. Groups (<c>g</c>) split it into meshes;
/// objects (<c>o</c>) do not, as in Unity: without a group the one mesh is called <c>default</c>.
/// </summary>
public sealed class ObjFile
{
    private static readonly char[] Blank = [' ', '\t'];
    private readonly string path;
    private ObjGroup? group;
    private string groupName = "default";
    private string material = "";

    private ObjFile(string path) => this.path = path;

    public List<Vector3> Positions { get; } = [];
    public List<Vector3> Normals { get; } = [];
    public List<Vector2> TextureCoordinates { get; } = [];
    public List<ObjGroup> Groups { get; } = [];

    public static ObjFile Read(string path) => Parse(File.ReadAllText(path), path);

    public static ObjFile Parse(string text, string path)
    {
        var obj = new ObjFile(path);
        using var reader = new StringReader(text);
        int number = 0;
        while (reader.ReadLine() is { } line)
        {
            int first = ++number;
            while (line.EndsWith('\\') && reader.ReadLine() is { } more)
            {
                line = line[..^1] + " " + more;
                number++;
            }
            int comment = line.IndexOf('#');
            if (comment >= 0) line = line[..comment];
            string[] words = line.Split(Blank, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length > 0) obj.ReadStatement(words, first);
        }
        return obj;
    }

    private void ReadStatement(string[] words, int line)
    {
        switch (words[0])
        {
            case "v": Positions.Add(new Vector3(Number(words, 1, line), Number(words, 2, line), Number(words, 3, line))); break;
            case "vn": Normals.Add(new Vector3(Number(words, 1, line), Number(words, 2, line), Number(words, 3, line))); break;
            case "vt": TextureCoordinates.Add(new Vector2(Number(words, 1, line), words.Length > 2 ? Number(words, 2, line) : 0)); break;
            case "g": (groupName, group) = (words.Length > 1 ? string.Join(' ', words.Skip(1)) : "default", null); break;
            case "usemtl": material = words.Length > 1 ? string.Join(' ', words.Skip(1)) : ""; break;
            case "f": ReadFace(words, line); break;
        }
    }

    private void ReadFace(string[] words, int line)
    {
        if (words.Length < 4) throw new ImportException($"{path}:{line}: a face needs at least 3 corners, found {words.Length - 1}.");
        var corners = new ObjCorner[words.Length - 1];
        for (int i = 0; i < corners.Length; i++)
        {
            string[] parts = words[i + 1].Split('/');
            corners[i] = new ObjCorner(
                Index(parts[0], Positions.Count, "vertex", line),
                parts.Length > 1 && parts[1].Length > 0 ? Index(parts[1], TextureCoordinates.Count, "texture coordinate", line) : -1,
                parts.Length > 2 && parts[2].Length > 0 ? Index(parts[2], Normals.Count, "normal", line) : -1);
        }
        if (group is null)
        {
            group = Groups.Find(g => g.Name == groupName);
            if (group is null) Groups.Add(group = new ObjGroup(groupName));
        }
        group.Faces.Add(new ObjFace(corners, material));
    }

    private int Index(string text, int count, string what, int line)
    {
        if (!int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int index))
            throw new ImportException($"{path}:{line}: '{text}' is not a {what} index.");
        int at = index < 0 ? count + index : index - 1;
        return at >= 0 && at < count
            ? at
            : throw new ImportException($"{path}:{line}: {what} index {index} is outside the {count} read so far.");
    }

    private float Number(string[] words, int at, int line)
    {
        if (at < words.Length && float.TryParse(words[at], NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && float.IsFinite(value)) return value;
        throw new ImportException($"{path}:{line}: '{words[0]}' needs a finite number as its component {at}, found '{(at < words.Length ? words[at] : "")}'.");
    }
}
