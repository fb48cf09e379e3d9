using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Which passes of a shader a stage of the pipeline draws, by LightMode.</summary>
internal static class PassSelection
{
    private const string Base = "ForwardBase";
    private const string Additive = "ForwardAdd";

    /// <summary>All passes of the forward pipeline; the variables of lights are those of another object afterwards.</summary>
    /// <param name="lights">For shaders with a ForwardBase pass: the object's.</param>
    public static void DrawForward(DrawRequest draw, ObjectLights lights)
    {
        foreach (PassProgram pass in draw.Material.Usable.Programs.Passes)
        {
            bool additive = Is(pass, Additive);
            if ((!additive && !IsForward(pass)) || !draw.Material.GetShaderPassEnabled(pass.LightMode) || !draw.Geometry.Prepare())
            {
                continue;
            }

            if (!additive)
            {
                Drawer.DrawPass(draw.Material, pass, draw.Block, draw.Geometry, draw.Matrix);
                continue;
            }

            foreach (Light light in lights.Pixel)
            {
                LightSettings.ApplyPixel(light);
                Drawer.DrawPass(draw.Material, pass, draw.Block, draw.Geometry, draw.Matrix);
            }
        }
    }

    /// <summary>Whether the shader is lit by the forward pipeline at all, and whether by more than one light of a pixel.</summary>
    public static (bool Lit, bool Additive) Lighting(Material material)
    {
        IReadOnlyList<PassProgram> passes = material.Usable.Programs.Passes;
        return (passes.Any(p => Is(p, Base)), passes.Any(p => Is(p, Additive) && material.GetShaderPassEnabled(p.LightMode)));
    }

    public static void DrawShadow(DrawRequest draw)
    {
        if (ShadowPass(draw.Material) is { } pass && draw.Geometry.Prepare())
        {
            Drawer.DrawPass(draw.Material, pass, draw.Block, draw.Geometry, draw.Matrix);
        }
    }

    /// <summary>The shader's own ShadowCaster pass or its fallback's; null when it casts none.</summary>
    public static PassProgram? ShadowPass(Material material)
    {
        Shader? shader = material.Usable;
        for (int depth = 0; shader is not null && depth < 8; depth++)
        {
            foreach (PassProgram pass in shader.Programs.Passes)
            {
                if (pass.LightMode.Equals("ShadowCaster", StringComparison.OrdinalIgnoreCase))
                {
                    return material.GetShaderPassEnabled(pass.LightMode) ? pass : null;
                }
            }

            string fallback = shader.Programs.Source.Fallback;
            shader = fallback.Length > 0 ? Shader.Find(fallback) : null;
        }

        return null;
    }

    private static bool IsForward(PassProgram pass) => pass.LightMode.Length == 0 || Is(pass, "Always") || Is(pass, Base);

    private static bool Is(PassProgram pass, string lightMode) => pass.LightMode.Equals(lightMode, StringComparison.OrdinalIgnoreCase);
}
