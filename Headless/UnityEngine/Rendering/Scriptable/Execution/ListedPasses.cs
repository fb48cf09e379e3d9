using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The passes of a material that drawing settings name: the first of each name, in the order of the names.</summary>
internal sealed class ListedPasses
{
    private readonly DrawingSettings drawing;
    private readonly string[] names;
    private readonly Dictionary<Material, (Material Material, ShaderProgramSet Programs, PassProgram Pass)[]> found = [];

    public ListedPasses(in DrawingSettings drawing)
    {
        this.drawing = drawing;
        var given = new List<string>();
        for (int i = 0; i < DrawingSettings.maxShaderPasses; i++)
        {
            if (drawing.GetShaderPassName(i) is { name.Length: > 0 } name)
            {
                given.Add(name.name);
            }
        }

        names = [.. given];
    }

    public (Material Material, ShaderProgramSet Programs, PassProgram Pass)[] Of(Material material)
    {
        if (!found.TryGetValue(material, out (Material Material, ShaderProgramSet Programs, PassProgram Pass)[]? passes))
        {
            passes = [.. Find(material)];
            found.Add(material, passes);
        }

        return passes;
    }

    private IEnumerable<(Material Material, ShaderProgramSet Programs, PassProgram Pass)> Find(Material material)
    {
        if (drawing.fallbackMaterial is { } fallback && fallback != null && !material.shader.isSupported)
        {
            material = fallback;
        }

        ShaderProgramSet own = material.Usable.Programs;
        PassProgram[] named = [.. names.Select(n => Named(own, material, n)).OfType<PassProgram>().Distinct()];
        if (named.Length == 0)
        {
            yield break;
        }

        if (drawing.overrideMaterial is { } other && other != null)
        {
            foreach (PassProgram pass in Numbered(other.Usable.Programs, drawing.overrideMaterialPassIndex))
            {
                yield return (other, other.shader.Programs, pass);
            }
        }
        else if (drawing.overrideShader is { } shader && shader != null)
        {
            foreach (PassProgram pass in Numbered(shader.Usable.Programs, drawing.overrideShaderPassIndex))
            {
                yield return (material, shader.Programs, pass);
            }
        }
        else
        {
            foreach (PassProgram pass in named)
            {
                yield return (material, material.shader.Programs, pass);
            }
        }
    }

    /// <summary>A pass without LightMode is called SRPDefaultUnlit.</summary>
    private static PassProgram? Named(ShaderProgramSet programs, Material material, string name)
    {
        bool unnamed = name.Equals("SRPDefaultUnlit", StringComparison.OrdinalIgnoreCase);
        return programs.Passes.FirstOrDefault(p =>
            (p.LightMode.Equals(name, StringComparison.OrdinalIgnoreCase) || (unnamed && p.LightMode.Length == 0))
            && material.GetShaderPassEnabled(name));
    }

    /// <summary>Below 0 all.</summary>
    private static IEnumerable<PassProgram> Numbered(ShaderProgramSet programs, int index) =>
        index < 0 ? programs.Passes : programs.Passes.Skip(index).Take(1);
}
