using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Engine;

/// <summary>One pass of a shader with its variants, compiled when first drawn.</summary>
internal sealed class PassProgram
{
    private readonly Dictionary<string, PassVariant?> variants = new(StringComparer.Ordinal);
    private readonly KeywordSelection selection;

    public PassProgram(ShaderPass source)
    {
        Source = source;
        selection = new KeywordSelection(source.Program.KeywordSets);
        LightMode = Tag("LightMode");
    }

    public ShaderPass Source { get; }
    public string LightMode { get; }
    public IReadOnlyList<string> KeywordNames => selection.Names;

    public string Tag(string name)
    {
        foreach ((string key, string value) in Source.Tags)
        {
            if (string.Equals(key, name, StringComparison.OrdinalIgnoreCase))
            {
                return value;
            }
        }

        return string.Empty;
    }

    /// <summary>The variant for a material's keywords; null when it does not compile, which is said once.</summary>
    public PassVariant? Variant(HashSet<string> keywords)
    {
        string[] active = selection.Select(keywords);
        string key = string.Join(' ', active);
        if (variants.TryGetValue(key, out PassVariant? variant))
        {
            return variant;
        }

        try
        {
            variant = new PassVariant(GraphicsDevice.Compiler.CompilePass(Source, active));
        }
        catch (ShaderCompileException problem)
        {
            Debug.LogError(problem.Message);
        }
        catch (ShaderCompilerMissingException problem)
        {
            (EngineHooks.CompilerMissing ?? Debug.LogError)(problem.Message);
        }

        variants.Add(key, variant);
        return variant;
    }
}
