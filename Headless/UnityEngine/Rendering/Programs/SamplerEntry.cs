using System.Linq;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>A sampler: of the texture it is named after ("sampler_MainTex"), or described by its own name ("sampler_linear_clamp").</summary>
/// <param name="TextureId">Property number of the texture, or -1 when the name describes the sampler.</param>
internal readonly record struct SamplerEntry(
    int Binding, int TextureId, FilterMode Filter, TextureWrapMode U, TextureWrapMode V, TextureWrapMode W, bool Comparison)
{
    private static readonly (string Word, TextureWrapMode Mode)[] WrapWords =
    [
        ("mirroronce", TextureWrapMode.MirrorOnce), ("mirror", TextureWrapMode.Mirror),
        ("repeat", TextureWrapMode.Repeat), ("clamp", TextureWrapMode.Clamp),
    ];

    /// <remarks>Unity's rule: a filter word and a wrap word make an inline sampler, "Compare" a depth comparison.</remarks>
    public static SamplerEntry Parse(string name, int binding, bool comparison)
    {
        string words = name.ToLowerInvariant();
        FilterMode? filter = words switch
        {
            _ when words.Contains("trilinear") => FilterMode.Trilinear,
            _ when words.Contains("linear") => FilterMode.Bilinear,
            _ when words.Contains("point") => FilterMode.Point,
            _ => null,
        };
        bool inline = filter is not null && WrapWords.Any(w => words.Contains(w.Word));
        if (!inline && name.StartsWith("sampler", StringComparison.Ordinal) && name.Length > "sampler".Length)
        {
            return new SamplerEntry(binding, ShaderNames.Id(name["sampler".Length..]), default, default, default, default, comparison);
        }

        return new SamplerEntry(binding, -1, filter ?? FilterMode.Bilinear, Wrap(words, 'u'), Wrap(words, 'v'), Wrap(words, 'w'), comparison);
    }

    private static TextureWrapMode Wrap(string words, char axis)
    {
        foreach ((string word, TextureWrapMode mode) in WrapWords)
        {
            if (words.Contains(word + axis))
            {
                return mode;
            }
        }

        foreach ((string word, TextureWrapMode mode) in WrapWords)
        {
            if (words.Contains(word) && !words.Contains(word + "u") && !words.Contains(word + "v") && !words.Contains(word + "w"))
            {
                return mode;
            }
        }

        return TextureWrapMode.Repeat;
    }
}
