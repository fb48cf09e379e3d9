using System.Globalization;
using System.Numerics;
using Headless.Files;

namespace Headless.Importers.Models;

/// <summary>
/// A Wavefront .obj file as written: right-handed, polygons, 0-based indices. Groups (<c>g</c>) split it into meshes;
/// objects (<c>o</c>) do not, as in Unity: without a group the one mesh is called <c>default</c>.
/// </summary>
public sealed class ObjFile
{
    private const long LargestFile = 256L << 20;

    /// <summary>Corners of one face: more than any program writes for a cap of a cylinder.</summary>
    private const int MostCorners = 4096;

    /// <summary>Triangles of a file: some 800 MB while they are imported.</summary>
    private const int MostTriangles = 1_000_000;
    private const int MostVertices = 4_000_000;
    private const int MostGroups = 10_000;

    private const string Cure = "Correct it, or export the model again.";
    private static readonly char[] Blank = [' ', '\t'];
    private readonly string path;
    private readonly Dictionary<string, ObjGroup> groupsByName = new(StringComparer.Ordinal);
    private int triangles;
    private ObjGroup? group;
    private string groupName = "default";
    private string material = "";

    private ObjFile(string path) => this.path = path;

    public List<Vector3> Positions { get; } = [];
    public List<Vector3> Normals { get; } = [];
    public List<Vector2> TextureCoordinates { get; } = [];
    public List<ObjGroup> Groups { get; } = [];

    /// <summary>What dividing its faces has cost so far; see <see cref="PolygonTriangulator"/>.</summary>
    internal long TriangulationWork;

    /// <exception cref="ImportException">A statement cannot be read, or the model is too large.</exception>
    public static ObjFile Read(string path)
    {
        using StreamReader reader = BoundedText.Open(path, LargestFile);
        return Parse(reader, path);
    }

    public static ObjFile Parse(string text, string path) => Parse(new StringReader(text), path);

    private static ObjFile Parse(TextReader reader, string path)
    {
        var obj = new ObjFile(path);
        var lines = new BoundedLines(reader, path);
        while (lines.Next() is { } line)
        {
            int comment = line.IndexOf('#');
            if (comment >= 0) line = line[..comment];
            string[] words = line.Split(Blank, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length > 0) obj.ReadStatement(words, lines.First);
        }
        foreach (ObjFace face in obj.Groups.SelectMany(g => g.Faces)) obj.CheckIndices(face);
        return obj;
    }

    private void ReadStatement(string[] words, int line)
    {
        switch (words[0])
        {
            case "v": Add(Positions, line, new Vector3(Number(words, 1, line), Number(words, 2, line), Number(words, 3, line))); break;
            case "vn": Add(Normals, line, new Vector3(Number(words, 1, line), Number(words, 2, line), Number(words, 3, line))); break;
            case "vt": Add(TextureCoordinates, line, new Vector2(Number(words, 1, line), words.Length > 2 ? Number(words, 2, line) : 0)); break;
            case "g": (groupName, group) = (words.Length > 1 ? string.Join(' ', words.Skip(1)) : "default", null); break;
            case "usemtl": material = words.Length > 1 ? string.Join(' ', words.Skip(1)) : ""; break;
            case "f": ReadFace(words, line); break;
        }
    }

    private void Add<T>(List<T> list, int line, T value)
    {
        if (list.Count >= MostVertices)
            throw new ImportException($"{path}:{line}: the model has more than {MostVertices} vertices from here on. Divide it, or reduce it in the modelling program.");
        list.Add(value);
    }

    private void ReadFace(string[] words, int line)
    {
        if (words.Length < 4) throw new ImportException($"{path}:{line}: a face needs at least 3 corners, found {words.Length - 1}. Remove it, or export the model again.");
        if (words.Length - 1 > MostCorners)
            throw new ImportException($"{path}:{line}: a face with {words.Length - 1} corners; at most {MostCorners} are read. Triangulate it in the modelling program.");
        triangles += words.Length - 3;
        if (triangles > MostTriangles)
            throw new ImportException($"{path}:{line}: the model has more than {MostTriangles} triangles from here on. Divide it, or reduce it in the modelling program.");
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
            if (!groupsByName.TryGetValue(groupName, out group))
            {
                if (Groups.Count >= MostGroups)
                    throw new ImportException($"{path}:{line}: more than {MostGroups} groups, each of them a mesh. Join some in the modelling program.");
                Groups.Add(groupsByName[groupName] = group = new ObjGroup(groupName));
            }
        }
        group.Faces.Add(new ObjFace(corners, material, line));
    }

    // A face may name what the file lists behind it.
    private void CheckIndices(ObjFace face)
    {
        foreach (ObjCorner corner in face.Corners)
        {
            Check(corner.Position, Positions.Count, "vertex");
            Check(corner.TextureCoordinate, TextureCoordinates.Count, "texture coordinate");
            Check(corner.Normal, Normals.Count, "normal");
        }

        void Check(int at, int count, string what)
        {
            if (at >= count) throw new ImportException($"{path}:{face.Line}: {what} index {at + 1L} is outside the {count} of the file. {Cure}");
        }
    }

    private int Index(string text, int count, string what, int line)
    {
        if (!int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int index))
            throw new ImportException($"{path}:{line}: '{OneLine.Value(text)}' is not a {what} index. {Cure}");
        int at = index < 0 ? count + index : index - 1;
        return at >= 0 ? at : throw new ImportException($"{path}:{line}: {what} index {index} is outside the {count} read so far. {Cure}");
    }

    private float Number(string[] words, int at, int line)
    {
        if (at < words.Length && float.TryParse(words[at], NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && float.IsFinite(value)) return value;
        throw new ImportException($"{path}:{line}: '{words[0]}' needs a finite number as its component {at}, found '{(at < words.Length ? OneLine.Value(words[at]) : "")}'. {Cure}");
    }
}
