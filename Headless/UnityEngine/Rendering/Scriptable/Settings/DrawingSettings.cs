using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>Which passes of its objects a renderer list draws, in which order and with which data.</summary>
public record struct DrawingSettings
{
    public static readonly int maxShaderPasses = ShaderPassNames.Count;

    private ShaderPassNames names;

    public DrawingSettings(ShaderTagId shaderPassName, SortingSettings sortingSettings)
    {
        names[0] = shaderPassName;
        this.sortingSettings = sortingSettings;
        enableInstancing = true;
        mainLightIndex = -1;
    }

    public SortingSettings sortingSettings { get; set; }
    public PerObjectData perObjectData { get; set; }
    public bool enableDynamicBatching { get; set; }
    public bool enableInstancing { get; set; }
    public Material? overrideMaterial { get; set; }
    public Shader? overrideShader { get; set; }
    public int overrideMaterialPassIndex { get; set; }
    public int overrideShaderPassIndex { get; set; }
    public Material? fallbackMaterial { get; set; }
    public int mainLightIndex { get; set; }

    public readonly ShaderTagId GetShaderPassName(int index) => names[Checked(index)];

    public void SetShaderPassName(int index, ShaderTagId shaderPassName) => names[Checked(index)] = shaderPassName;

    private static int Checked(int index) => index >= 0 && index < ShaderPassNames.Count
        ? index
        : throw new ArgumentOutOfRangeException(nameof(index), $"Index should range from 0 to DrawingSettings.maxShaderPasses ({maxShaderPasses}), was {index}");
}
