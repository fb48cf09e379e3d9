using Headless.Shaders;
using Headless.Shaders.Direct3D;

namespace Headless.Checks.Fxc;

/// <summary>One entry point with one choice of keywords, as Unity hands it to the D3D11 compiler.</summary>
internal sealed record FxcJob(string Name, string Entry, string Profile, string Text)
{
    /// <summary>Path of the file that declares the entry point, below the package's folder as it was given.</summary>
    public string File { get; init; } = "";

    /// <summary>The keywords that are on.</summary>
    public IReadOnlyList<string> Keywords { get; init; } = [];

    public bool IsKernel => Profile.StartsWith("cs", StringComparison.Ordinal);

    public static IEnumerable<FxcJob> FromCompute(ComputeSource source)
    {
        foreach (var kernel in source.Kernels)
            foreach (var keywords in Variants(source.KeywordSets))
                yield return new FxcJob(Label(source.Path, kernel.Name, keywords), kernel.Name, "cs_5_0",
                    Build(source.Expanded, ShaderStage.Compute, 50, kernel.Defines, keywords))
                { Keywords = keywords };
    }

    public static IEnumerable<FxcJob> FromShader(ShaderLabSource shader)
    {
        foreach (var pass in shader.SubShaders.SelectMany(s => s.Passes))
            foreach (var keywords in Variants(pass.Program.KeywordSets))
                foreach (var (stage, entry, profile) in Stages(pass.Program))
                    yield return new FxcJob(Label(shader.Path, $"{pass.Name} {entry}", keywords), entry, profile,
                        Build(pass.Program.Expanded, stage, pass.Program.Target, pass.Defines, keywords))
                    { Keywords = keywords };
    }

    private static IEnumerable<(ShaderStage, string, string)> Stages(ShaderProgram program)
    {
        yield return (ShaderStage.Vertex, program.Vertex, "vs_5_0");
        if (program.Geometry.Length > 0) yield return (ShaderStage.Geometry, program.Geometry, "gs_5_0");
        yield return (ShaderStage.Fragment, program.Fragment, "ps_5_0");
    }

    /// <summary>Every choice of one keyword a set: the product of the sets.</summary>
    public static IEnumerable<IReadOnlyList<string>> Variants(IReadOnlyList<KeywordSet> sets)
    {
        IEnumerable<IReadOnlyList<string>> variants = [[]];
        foreach (var set in sets)
            variants = variants.SelectMany(chosen => set.Keywords.Select(k => k.Length == 0 ? chosen : (IReadOnlyList<string>)[.. chosen, k]));
        return variants;
    }

    private static string Label(string path, string entry, IReadOnlyList<string> keywords) =>
        $"{Path.GetFileName(path)} {entry.Trim()}{(keywords.Count > 0 ? " [" + string.Join(' ', keywords) + "]" : "")}";

    private static string Build(ExpandedSource source, ShaderStage stage, int target, IEnumerable<KeyValuePair<string, string>> defines, IReadOnlyCollection<string> keywords) =>
        FxcText.From(StageText.Build(source, stage, target, defines, keywords), source);
}
