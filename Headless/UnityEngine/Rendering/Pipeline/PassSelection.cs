using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Which passes of a shader a stage of the pipeline draws, by LightMode.</summary>
internal static class PassSelection
{
    public static void DrawForward(DrawRequest draw)
    {
        foreach (PassProgram pass in draw.Material.Usable.Programs.Passes)
        {
            if (IsForward(pass.LightMode) && draw.Material.GetShaderPassEnabled(pass.LightMode) && draw.Geometry.Prepare())
            {
                Drawer.DrawPass(draw.Material, pass, draw.Block, draw.Geometry, draw.Matrix);
            }
        }
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

    private static bool IsForward(string lightMode) =>
        lightMode.Length == 0
        || lightMode.Equals("Always", StringComparison.OrdinalIgnoreCase)
        || lightMode.Equals("ForwardBase", StringComparison.OrdinalIgnoreCase);
}
