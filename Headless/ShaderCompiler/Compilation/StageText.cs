namespace Headless.Shaders;

/// <summary>Builds the text of a stage: what Unity defines for Direct3D 11, keywords, then the source.</summary>
internal static class StageText
{
    /// <summary>Macros of every stage.</summary>
    public static readonly IReadOnlyDictionary<string, string> Constants = new Dictionary<string, string>
    {
        ["SHADER_API_D3D11"] = "1",
        ["SHADER_API_DESKTOP"] = "1",
        ["UNITY_VERSION"] = "202230",
    };

    private const string Stage = "SHADER_STAGE_";
    private const string Target = "SHADER_TARGET";

    /// <summary>Whether a macro, keywords aside, is not the same in all stages of all passes.</summary>
    public static bool Varies(string name) =>
        name == Target || name.StartsWith(Stage, StringComparison.Ordinal) || name.StartsWith(ShaderPass.DefinePrefix, StringComparison.Ordinal);

    public static string Build(
        ExpandedSource source, ShaderStage stage, int target, IEnumerable<KeyValuePair<string, string>> defines,
        IReadOnlyCollection<string> keywords) =>
        Defines(source, stage, target, defines, keywords) + FxcRules.WriteCalls(source.Hlsl);

    /// <summary>The same as it is written, without FXC's rules.</summary>
    public static string Plain(
        ExpandedSource source, ShaderStage stage, int target, IEnumerable<KeyValuePair<string, string>> defines,
        IReadOnlyCollection<string> keywords) =>
        Defines(source, stage, target, defines, keywords) + source.Text;

    private static string Defines(
        ExpandedSource source, ShaderStage stage, int target, IEnumerable<KeyValuePair<string, string>> defines,
        IReadOnlyCollection<string> keywords)
    {
        IEnumerable<KeyValuePair<string, string>> all =
        [
            .. Constants,
            KeyValuePair.Create(Stage + stage.ToString().ToUpperInvariant(), "1"),
            KeyValuePair.Create(Target, target.ToString()),
            .. defines,
            .. keywords.Select(k => KeyValuePair.Create(k, "1")),
            .. source.BranchKeywords.Except(keywords).Select(k => KeyValuePair.Create(k, "0")),
        ];
        return string.Concat(all.Select(d => $"#define {d.Key} {d.Value}\n"));
    }
}
