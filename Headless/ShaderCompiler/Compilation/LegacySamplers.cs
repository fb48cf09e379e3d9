using System.Text;
using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Turns Direct3D 9 samplers into a texture and a sampler of its own, as FXC does for Shader Model 4 and later.</summary>
/// <remarks>
/// "sampler2D _MainTex;" becomes "Texture2D _MainTex; SamplerState sampler_MainTex;" and tex2D(_MainTex, uv) the matching
/// Sample call. A sampler2D as a parameter of a function is left alone and thus an error of the compiler.
/// </remarks>
internal static partial class LegacySamplers
{
    private const string Macros = """
        #define tex2D(s, c) s.Sample(sampler##s, (c))
        #define tex2Dlod(s, c) s.SampleLevel(sampler##s, (c).xy, (c).w)
        #define tex2Dbias(s, c) s.SampleBias(sampler##s, (c).xy, (c).w)
        #define tex2Dgrad(s, c, dx, dy) s.SampleGrad(sampler##s, (c), dx, dy)
        #define tex2Dproj(s, c) s.Sample(sampler##s, (c).xy / (c).w)
        #define tex3D(s, c) s.Sample(sampler##s, (c))
        #define tex3Dlod(s, c) s.SampleLevel(sampler##s, (c).xyz, (c).w)
        #define texCUBE(s, c) s.Sample(sampler##s, (c))
        #define texCUBElod(s, c) s.SampleLevel(sampler##s, (c).xyz, (c).w)
        #define texCUBEbias(s, c) s.SampleBias(sampler##s, (c).xyz, (c).w)

        """;

    public static string Rewrite(string text)
    {
        if (!Declaration().IsMatch(text))
        {
            return text;
        }
        return Macros.ReplaceLineEndings("\n") + Declaration().Replace(text, Replacement);
    }

    private static string Replacement(Match match)
    {
        string texture = match.Groups["kind"].Value switch { "3D" => "Texture3D", "CUBE" => "TextureCube", _ => "Texture2D" };
        StringBuilder declarations = new();
        foreach (string name in match.Groups["names"].Value.Split(','))
        {
            declarations.Append($"{texture} {name.Trim()}; SamplerState sampler{name.Trim()}; ");
        }
        return declarations.Append('\n', match.Value.Count(c => c == '\n')).ToString();
    }

    [GeneratedRegex(@"(?:\buniform\s+)?\bsampler(?<kind>2D|3D|CUBE)(?:_float|_half)?\s+(?<names>\w+(?:\s*,\s*\w+)*)\s*;")]
    private static partial Regex Declaration();
}
