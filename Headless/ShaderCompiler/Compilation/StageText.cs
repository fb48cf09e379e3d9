using System.Text;

namespace Headless.Shaders;

/// <summary>Builds the text of a stage: what Unity defines for Direct3D 11, keywords, then the source.</summary>
internal static class StageText
{
    public const int UnityVersion = 202230;

    public static string Build(
        ExpandedSource source, ShaderStage stage, int target, IEnumerable<KeyValuePair<string, string>> defines,
        IEnumerable<string> keywords)
    {
        StringBuilder text = new();
        Define(text, "SHADER_API_D3D11", "1");
        Define(text, "SHADER_API_DESKTOP", "1");
        Define(text, "SHADER_STAGE_" + stage.ToString().ToUpperInvariant(), "1");
        Define(text, "SHADER_TARGET", target.ToString());
        Define(text, "UNITY_VERSION", UnityVersion.ToString());
        foreach ((string name, string value) in defines)
        {
            Define(text, name, value);
        }
        foreach (string keyword in keywords)
        {
            Define(text, keyword, "1");
        }
        text.Append(MatrixSwizzles.Rewrite(LegacySamplers.Rewrite(source.Hlsl)));
        return text.ToString();
    }

    private static void Define(StringBuilder text, string name, string value) =>
        text.Append("#define ").Append(name).Append(' ').Append(value).Append('\n');
}
