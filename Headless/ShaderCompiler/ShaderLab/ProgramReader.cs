using System.Globalization;

namespace Headless.Shaders;

/// <summary>Turns a program block with the include blocks before it into a <see cref="ShaderProgram"/>.</summary>
internal static class ProgramReader
{
    private const int DefaultTarget = 25;
    private const string Renderer = "d3d11";

    private static readonly string[] AutomaticIncludes = ["HLSLSupport.cginc", "UnityShaderVariables.cginc"];

    /// <param name="path">Full path of the file.</param>
    /// <param name="includeBlocks">HLSLINCLUDE and CGINCLUDE blocks in order.</param>
    public static ShaderProgram Read(
        string path, ShaderLabToken program, IReadOnlyList<ShaderLabToken> includeBlocks, IncludeResolver includes,
        ref UnsupportedFeature? unsupported)
    {
        string shown = includes.Shown(path);
        if (program.Keyword == "GLSLPROGRAM")
        {
            throw new ShaderCompileException(shown, program.Line, "GLSLPROGRAM is not supported; write HLSLPROGRAM");
        }
        List<SourceBlock> blocks = [];
        if (program.Keyword == "CGPROGRAM")
        {
            string automatic = string.Concat(AutomaticIncludes.Select(i => $"#include \"{i}\"\n"));
            blocks.Add(new SourceBlock(path, automatic, 1));
        }
        blocks.AddRange(includeBlocks.Select(b => new SourceBlock(path, b.Text, b.Line)));
        blocks.Add(new SourceBlock(path, program.Text, program.Line));
        ExpandedSource expanded = IncludeExpander.Expand(includes, blocks);

        Dictionary<string, string> entries = [];
        List<KeywordSet> sets = [];
        List<string> requires = [];
        int target = DefaultTarget;
        List<(int, IReadOnlyList<string>)> keywordTargets = [];
        foreach (PragmaLine pragma in expanded.Pragmas)
        {
            string word = pragma.Words[0];
            switch (word)
            {
                case "vertex" or "fragment" or "geometry":
                    entries[word] = Argument(pragma);
                    break;
                case "target" when pragma.Words.Count > 2:
                    keywordTargets.Add((Target(pragma), [.. pragma.Words.Skip(2)]));
                    break;
                case "target":
                    target = Target(pragma);
                    break;
                case "require":
                    requires.AddRange(pragma.Words.Skip(1).Where(w => w != ":"));
                    break;
                case "only_renderers" when !pragma.Words.Contains(Renderer):
                case "exclude_renderers" when pragma.Words.Contains(Renderer):
                    unsupported ??= new UnsupportedFeature(pragma.Line, $"the program is not for Direct3D 11; add {Renderer} to \"#pragma only_renderers\", or take it from \"#pragma exclude_renderers\"");
                    break;
                case "surface":
                    unsupported ??= new UnsupportedFeature(pragma.Line, "surface shaders are not supported; write vertex and fragment functions");
                    break;
                case "hull" or "domain":
                    unsupported ??= new UnsupportedFeature(pragma.Line, "tessellation is not supported by the headless player");
                    break;
                default:
                    sets.AddRange(KeywordPragmas.Read(pragma) ?? []);
                    break;
            }
        }
        string missing = !entries.ContainsKey("vertex") ? "vertex" : !entries.ContainsKey("fragment") ? "fragment" : "";
        if (missing.Length > 0)
        {
            unsupported ??= new UnsupportedFeature(program.Line, $"the program has no \"#pragma {missing} function\"");
        }
        if (entries.ContainsKey("geometry") && !requires.Contains("geometry"))
        {
            requires.Add("geometry");
        }
        return new ShaderProgram(
            shown, entries.GetValueOrDefault("vertex", ""), entries.GetValueOrDefault("geometry", ""),
            entries.GetValueOrDefault("fragment", ""), target, sets, requires)
        {
            Expanded = expanded,
            KeywordTargets = keywordTargets,
        };
    }

    private static string Argument(PragmaLine pragma) => pragma.Words.Count > 1
        ? pragma.Words[1]
        : throw new ShaderCompileException(pragma.File, pragma.Line, $"#pragma {pragma.Words[0]} needs a function name");

    private static int Target(PragmaLine pragma)
    {
        string text = Argument(pragma);
        return float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && value is >= 2 and < 7
            ? (int)MathF.Round(value * 10)
            : throw new ShaderCompileException(pragma.File, pragma.Line, $"unknown shader target '{text}'");
    }
}
