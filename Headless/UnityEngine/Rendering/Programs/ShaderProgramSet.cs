using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The parsed side of a Shader: the SubShader that fits this device and pipeline, its passes and the property defaults.</summary>
internal sealed class ShaderProgramSet
{
    private readonly Dictionary<SubShader, PassProgram[]> made = [];
    private string? pipeline;
    private SubShader? chosen;
    private PassProgram[] passes = [];
    private string[] keywords = [];

    public ShaderProgramSet(ShaderLabSource source)
    {
        Source = source;
        foreach (ShaderProperty property in source.Properties)
        {
            AddDefault(property);
        }
    }

    public ShaderLabSource Source { get; }

    /// <summary>The first that fits; chosen again when the render pipeline changes.</summary>
    public SubShader? SubShader
    {
        get
        {
            Choose();
            return chosen;
        }
    }

    public IReadOnlyList<PassProgram> Passes
    {
        get
        {
            Choose();
            return passes;
        }
    }

    public string[] KeywordNames
    {
        get
        {
            Choose();
            return keywords;
        }
    }

    public PropertySheet Defaults { get; } = new();

    /// <summary>Names of default textures ("white", "bump"...) by property number.</summary>
    public Dictionary<int, string> TextureDefaults { get; } = [];

    public int RenderQueue => QueueParser.Parse(Tag("Queue"), Source.Name);

    public string Tag(string name)
    {
        foreach ((string key, string value) in SubShader?.Tags ?? new Dictionary<string, string>())
        {
            if (string.Equals(key, name, StringComparison.OrdinalIgnoreCase))
            {
                return value;
            }
        }

        return string.Empty;
    }

    public int FindProperty(string name)
    {
        for (int i = 0; i < Source.Properties.Count; i++)
        {
            if (Source.Properties[i].Name == name)
            {
                return i;
            }
        }

        return -1;
    }

    public static bool IsTexture(ShaderProperty property) => property.Type >= ShaderPropertyType.Texture2D;

    private void Choose()
    {
        if (pipeline == Shader.globalRenderPipeline)
        {
            return;
        }

        pipeline = Shader.globalRenderPipeline;
        chosen = Source.SubShaders.FirstOrDefault(s => Fits(s, pipeline));
        passes = chosen is null ? [] : Programs(chosen);
        keywords = [.. passes.SelectMany(p => p.KeywordNames).Distinct()];
    }

    private PassProgram[] Programs(SubShader subShader)
    {
        if (!made.TryGetValue(subShader, out PassProgram[]? programs))
        {
            programs = [.. subShader.Passes.Select(p => new PassProgram(p))];
            made.Add(subShader, programs);
        }

        return programs;
    }

    /// <summary>A SubShader for another render pipeline, or that needs a stage that the device does not have, does not fit.</summary>
    private static bool Fits(SubShader subShader, string pipeline)
    {
        bool otherPipeline = subShader.Tags.Any(t =>
            string.Equals(t.Key, "RenderPipeline", StringComparison.OrdinalIgnoreCase) && t.Value.Length > 0
            && !string.Equals(t.Value, pipeline, StringComparison.OrdinalIgnoreCase));
        bool needsGeometry = subShader.Passes.Any(p => p.Program.Geometry.Length > 0);
        return !otherPipeline && (!needsGeometry || GraphicsDevice.Device.Limits.GeometryShader);
    }

    private void AddDefault(ShaderProperty property)
    {
        int id = ShaderNames.Id(property.Name);
        var vector = new Vector4(property.Default[0], property.Default[1], property.Default[2], property.Default[3]);
        switch (property.Type)
        {
            case ShaderPropertyType.Float or ShaderPropertyType.Range:
                Defaults.SetFloat(id, vector.x);
                break;
            case ShaderPropertyType.Integer:
                Defaults.SetInteger(id, (int)vector.x);
                break;
            case ShaderPropertyType.Color when property.Attributes.Contains("HDR"):
            case ShaderPropertyType.Vector:
                Defaults.SetVector(id, vector);
                break;
            case ShaderPropertyType.Color:
                Defaults.SetColor(id, new Color(vector.x, vector.y, vector.z, vector.w));
                break;
            default:
                TextureDefaults[id] = property.DefaultTexture;
                Defaults.SetVector(ShaderNames.Id(property.Name + "_ST"), new Vector4(1f, 1f, 0f, 0f));
                break;
        }
    }
}
