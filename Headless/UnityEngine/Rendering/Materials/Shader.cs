using System.Collections.Generic;
using System;
using Headless.Engine;
using Headless.Shaders;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Shader : Object
{
    private static string pipelineTag = string.Empty;

    internal Shader(ShaderLabSource source)
    {
        Programs = new ShaderProgramSet(source);
        name = source.Name;
        ShaderLibrary.Add(this);
    }

    public static int globalMaximumLOD { get; set; } = int.MaxValue;

    /// <summary>The value of the tag RenderPipeline of SubShaders that are for the active pipeline.</summary>
    public static string globalRenderPipeline
    {
        get => pipelineTag;
        set => pipelineTag = value ?? string.Empty;
    }


    /// <summary>True when a SubShader fits and its first pass compiles.</summary>
    public bool isSupported => Programs.SubShader is not null
        && (Programs.Passes.Count == 0 || Programs.Passes[0].Variant([]) is not null);

    public int maximumLOD { get; set; } = -1;
    public int renderQueue => Programs.RenderQueue;
    public int passCount => Programs.Passes.Count;
    public int subshaderCount => Programs.Source.SubShaders.Count;
    public LocalKeywordSpace keywordSpace => new(Programs.KeywordNames);

    internal ShaderProgramSet Programs { get; }

    /// <summary>The shader to draw with: this one, or its fallback where no SubShader fits.</summary>
    internal Shader Usable =>
        Programs.SubShader is null && Programs.Source.Fallback.Length > 0 && Find(Programs.Source.Fallback) is { } fallback && fallback != this
            ? fallback.Usable
            : this;

    public static Shader? Find(string name) => ShaderLibrary.Find(name);

    public static int PropertyToID(string name) => ShaderNames.Id(name);

    public static void WarmupAllShaders()
    {
        foreach (Shader shader in ShaderLibrary.All)
        {
            foreach (PassProgram pass in shader.Programs.Passes)
            {
                pass.Variant([]);
            }
        }
    }

    public int FindPropertyIndex(string propertyName) => Programs.FindProperty(propertyName);

    public int GetPropertyCount() => Programs.Source.Properties.Count;

    public string GetPropertyName(int propertyIndex) => Property(propertyIndex).Name;

    public int GetPropertyNameId(int propertyIndex) => ShaderNames.Id(Property(propertyIndex).Name);

    public string GetPropertyDescription(int propertyIndex) => Property(propertyIndex).Display;

    public string[] GetPropertyAttributes(int propertyIndex) => [.. Property(propertyIndex).Attributes];

    public Rendering.ShaderPropertyType GetPropertyType(int propertyIndex) => Property(propertyIndex).Type switch
    {
        Headless.Shaders.ShaderPropertyType.Float => Rendering.ShaderPropertyType.Float,
        Headless.Shaders.ShaderPropertyType.Range => Rendering.ShaderPropertyType.Range,
        Headless.Shaders.ShaderPropertyType.Integer => Rendering.ShaderPropertyType.Int,
        Headless.Shaders.ShaderPropertyType.Color => Rendering.ShaderPropertyType.Color,
        Headless.Shaders.ShaderPropertyType.Vector => Rendering.ShaderPropertyType.Vector,
        _ => Rendering.ShaderPropertyType.Texture,
    };

    public float GetPropertyDefaultFloatValue(int propertyIndex) => Property(propertyIndex).Default[0];

    public int GetPropertyDefaultIntValue(int propertyIndex) => (int)Property(propertyIndex).Default[0];

    public Vector4 GetPropertyDefaultVectorValue(int propertyIndex)
    {
        IReadOnlyList<float> v = Property(propertyIndex).Default;
        return new Vector4(v[0], v[1], v[2], v[3]);
    }

    public Vector2 GetPropertyRangeLimits(int propertyIndex) => new(Property(propertyIndex).RangeMin, Property(propertyIndex).RangeMax);

    public string GetPropertyTextureDefaultName(int propertyIndex) => Property(propertyIndex).DefaultTexture;

    private ShaderProperty Property(int index)
    {
        if ((uint)index >= (uint)Programs.Source.Properties.Count)
        {
            throw new ArgumentOutOfRangeException(nameof(index), $"Shader '{name}' has {Programs.Source.Properties.Count} properties; there is none with index {index}.");
        }

        return Programs.Source.Properties[index];
    }
}
