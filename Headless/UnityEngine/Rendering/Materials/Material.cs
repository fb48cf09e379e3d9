using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Engine;

namespace UnityEngine;

public partial class Material : Object
{
    private readonly HashSet<string> disabledPasses = new(StringComparer.OrdinalIgnoreCase);
    private readonly Dictionary<string, string> overrideTags = new(StringComparer.OrdinalIgnoreCase);
    private Shader shaderField;
    private int customQueue = -1;

    public Material(Shader shader)
    {
        if (shader == null)
        {
            throw new ArgumentNullException(nameof(shader), "A material needs a shader: Shader.Find returns null for a name that is not in the project.");
        }

        shaderField = shader;
        name = shader.name;
    }

    public Material(Material source)
    {
        ArgumentNullException.ThrowIfNull(source);
        shaderField = source.shader;
        name = source.name;
        CopyPropertiesFromMaterial(source);
    }

    public Shader shader
    {
        get => shaderField;
        set => shaderField = value != null ? value : throw new ArgumentNullException(nameof(value), $"Material '{name}' needs a shader.");
    }

    public int renderQueue
    {
        get => customQueue >= 0 ? customQueue : Usable.renderQueue;
        set => customQueue = value;
    }

    public int passCount => Usable.passCount;
    public bool enableInstancing { get; set; }
    public bool doubleSidedGI { get; set; }
    public MaterialGlobalIlluminationFlags globalIlluminationFlags { get; set; }

    internal PropertySheet Sheet { get; } = new();

    /// <summary>The shader whose passes are drawn; the error shader where none fits.</summary>
    internal Shader Usable
    {
        get
        {
            Shader usable = shaderField.Usable;
            return usable.Programs.SubShader is null ? ShaderLibrary.Require("Hidden/InternalErrorShader") : usable;
        }
    }

    public int FindPass(string passName)
    {
        IReadOnlyList<PassProgram> passes = Usable.Programs.Passes;
        for (int i = 0; i < passes.Count; i++)
        {
            if (string.Equals(passes[i].Source.Name, passName, StringComparison.OrdinalIgnoreCase))
            {
                return i;
            }
        }

        return -1;
    }

    public string GetPassName(int pass) => (uint)pass < (uint)passCount ? Usable.Programs.Passes[pass].Source.Name : string.Empty;

    public void SetShaderPassEnabled(string passName, bool enabled)
    {
        if (enabled)
        {
            disabledPasses.Remove(passName);
        }
        else
        {
            disabledPasses.Add(passName);
        }
    }

    public bool GetShaderPassEnabled(string passName) => !disabledPasses.Contains(passName);

    public string GetTag(string tag, bool searchFallbacks) => GetTag(tag, searchFallbacks, string.Empty);

    public string GetTag(string tag, bool searchFallbacks, string defaultValue)
    {
        if (overrideTags.TryGetValue(tag, out string? value))
        {
            return value;
        }

        string found = Usable.Programs.Tag(tag);
        return found.Length > 0 ? found : defaultValue;
    }

    public void SetOverrideTag(string tag, string val)
    {
        if (string.IsNullOrEmpty(val))
        {
            overrideTags.Remove(tag);
        }
        else
        {
            overrideTags[tag] = val;
        }
    }

    public void CopyPropertiesFromMaterial(Material mat)
    {
        ArgumentNullException.ThrowIfNull(mat);
        Sheet.CopyFrom(mat.Sheet);
        Keywords.Replace(mat.Keywords.Enabled);
        customQueue = mat.customQueue;
        enableInstancing = mat.enableInstancing;
        disabledPasses.UnionWith(mat.disabledPasses);
    }

    public bool SetPass(int pass) => ImmediateDrawing.SetPass(this, pass);

    public int ComputeCRC() => HashCode.Combine(shaderField.name, renderQueue, string.Join(' ', Keywords.Enabled));

    internal override Object CloneNative() => new Material(this);
}
