namespace Headless.Shaders;

/// <summary>The HLSL of a pass with what its pragmas say.</summary>
/// <param name="Path">File of the program, for messages.</param>
/// <param name="Geometry">Entry point, "" when the pass has no geometry stage.</param>
/// <param name="Target">Shader target times ten: 25, 45, 50.</param>
/// <param name="Requires">Words of "#pragma require", "geometry" included where a geometry stage implies it.</param>
public sealed record ShaderProgram(
    string Path, string Vertex, string Geometry, string Fragment, int Target,
    IReadOnlyList<KeywordSet> KeywordSets, IReadOnlyList<string> Requires)
{
    internal ExpandedSource Expanded { get; init; } = new("", [Path], [], []);

    /// <summary>Targets of "#pragma target 4.5 KEYWORD", which are for variants with all of the keywords.</summary>
    internal IReadOnlyList<(int Target, IReadOnlyList<string> Keywords)> KeywordTargets { get; init; } = [];

    /// <summary>The target of a variant.</summary>
    internal int TargetOf(IReadOnlyCollection<string> keywords) =>
        KeywordTargets.Where(t => t.Keywords.All(keywords.Contains)).Select(t => t.Target).Append(Target).Max();

    /// <summary>HLSL with includes in place and #line directives.</summary>
    public string Source => Expanded.Text;
}
