namespace Headless.Shaders;

/// <summary>Reads multi_compile, shader_feature and dynamic_branch pragmas, Unity's named shortcuts included.</summary>
internal static class KeywordPragmas
{
    private static readonly Dictionary<string, string[][]> Shortcuts = new()
    {
        ["multi_compile_instancing"] = [["", "INSTANCING_ON"]],
        ["multi_compile_fog"] = [["", "FOG_LINEAR", "FOG_EXP", "FOG_EXP2"]],
        ["multi_compile_fwdbase"] = [["DIRECTIONAL"], ["", "SHADOWS_SCREEN"], ["", "VERTEXLIGHT_ON"]],
        ["multi_compile_fwdbasealpha"] = [["DIRECTIONAL"], ["", "SHADOWS_SCREEN"], ["", "VERTEXLIGHT_ON"]],
        ["multi_compile_fwdadd"] = [["POINT", "DIRECTIONAL", "SPOT", "POINT_COOKIE", "DIRECTIONAL_COOKIE"]],

        // Without the keywords of shadows: further lights cast none here, which the console says.
        ["multi_compile_fwdadd_fullshadows"] = [["POINT", "DIRECTIONAL", "SPOT", "POINT_COOKIE", "DIRECTIONAL_COOKIE"]],
        ["multi_compile_shadowcaster"] = [["SHADOWS_DEPTH", "SHADOWS_CUBE"]],
    };

    private static readonly HashSet<string> Suffixes =
        ["local", "vertex", "fragment", "geometry", "hull", "domain", "raytracing"];

    private const string BranchStem = "dynamic_branch";

    private static readonly string[] Stems = ["multi_compile", "shader_feature", BranchStem];

    public static bool IsBranch(IReadOnlyList<string> words) => words[0].StartsWith(BranchStem, StringComparison.Ordinal);

    /// <summary>Keywords that a pragma of these names, whether or not it is well formed.</summary>
    public static IEnumerable<string> Names(IReadOnlyList<string> words)
    {
        if (Shortcuts.TryGetValue(words[0], out string[][]? sets))
        {
            return sets.SelectMany(s => s);
        }
        return Array.Exists(Stems, stem => words[0].StartsWith(stem, StringComparison.Ordinal)) ? words.Skip(1) : [];
    }

    /// <summary>The sets a pragma declares; null when it is no keyword pragma.</summary>
    public static IReadOnlyList<KeywordSet>? Read(PragmaLine pragma)
    {
        string kind = pragma.Words[0];
        if (Shortcuts.TryGetValue(kind, out string[][]? sets))
        {
            return [.. sets.Where(s => !IsSkipped(s, pragma)).Select(s => new KeywordSet(s, Local: false, Feature: false))];
        }
        if (Array.Find(Stems, s => kind.StartsWith(s, StringComparison.Ordinal)) is not { } stem)
        {
            return null;
        }
        bool feature = stem == "shader_feature";
        string[] suffixes = kind[stem.Length..].Split('_', StringSplitOptions.RemoveEmptyEntries);
        if (suffixes.Any(s => !Suffixes.Contains(s)))
        {
            throw new ShaderCompileException(pragma.File, pragma.Line, $"unknown #pragma {kind}");
        }
        List<string> keywords = [.. pragma.Words.Skip(1).Select(w => w.All(c => c == '_') ? "" : w)];
        if (keywords.Count == 0)
        {
            throw new ShaderCompileException(pragma.File, pragma.Line, $"#pragma {kind} names no keyword");
        }
        bool branch = stem == BranchStem;
        if ((feature || branch) && keywords.Count == 1 && keywords[0].Length > 0)
        {
            keywords.Insert(0, "");
        }
        return [new KeywordSet(keywords, suffixes.Contains("local"), feature) { Branch = branch }];
    }

    // "#pragma multi_compile_fwdbase novertexlight"
    private static bool IsSkipped(string[] set, PragmaLine pragma) =>
        (set.Contains("VERTEXLIGHT_ON") && pragma.Words.Contains("novertexlight"))
        || (set.Contains("SHADOWS_SCREEN") && pragma.Words.Contains("noshadow"));
}
