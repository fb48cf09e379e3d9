using System.Linq;
using System;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Where drawing goes: color and depth textures, and whether pictures lie upside down in them.</summary>
internal sealed class DrawTarget
{
    public GpuTexture[] Colors { get; init; } = [];

    /// <summary>One-sample textures that receive the resolved colors; null entries for none.</summary>
    public GpuTexture?[] Resolves { get; init; } = [];

    public GpuTexture? Depth { get; init; }
    public int MipLevel { get; init; }

    /// <summary>-1 for all of an array.</summary>
    public int Slice { get; init; }

    /// <summary>
    /// True for render textures: row 0 is the bottom of the picture, so the projection is turned upside down and
    /// triangles change their winding, as Unity does on Direct3D. False for the screen.
    /// </summary>
    public bool Flipped { get; init; }

    public GpuTexture Any => Colors.Length > 0 ? Colors[0] : Depth ?? throw new InvalidOperationException("A draw target needs a color or depth texture.");
    public int Width => Math.Max(1, Any.Description.Width >> MipLevel);
    public int Height => Math.Max(1, Any.Description.Height >> MipLevel);
    public int Samples => Any.Description.Samples;
    public GpuFormat DepthFormat => Depth?.Description.Format ?? GpuFormat.None;

    public bool IsLayered => Slice < 0;

    public static DrawTarget Screen => new() { Colors = [ScreenTarget.Texture], Resolves = [null] };

    public static DrawTarget Of(RenderTexture texture, int mipLevel = 0, int slice = 0)
    {
        GpuTexture? color = texture.DrawTarget;
        GpuTexture? depth = texture.DepthTarget;
        return new DrawTarget
        {
            Colors = color is null ? [] : [color],
            Resolves = color is null ? [] : [texture.ResolveTarget],
            Depth = mipLevel == 0 ? depth : null,
            MipLevel = mipLevel,
            Slice = slice < 0 && texture.dimension != UnityEngine.Rendering.TextureDimension.Tex2DArray ? 0 : slice,
            Flipped = true,
        };
    }

    /// <summary>One slice of it.</summary>
    public DrawTarget Layer(int slice) => new()
    {
        Colors = Colors,
        Resolves = Resolves,
        Depth = Depth,
        MipLevel = MipLevel,
        Slice = slice,
        Flipped = Flipped,
    };

    /// <summary>A viewport from a rectangle with its origin at the bottom left of the picture.</summary>
    public GpuViewport Viewport(Rect rect) =>
        new(rect.x, Flipped ? rect.y : Height - rect.y - rect.height, rect.width, rect.height);

    public RenderTargets Begin(TargetLoad colorLoad, Color clear, TargetLoad depthLoad, float clearDepth, GpuViewport? viewport)
    {
        var color = new System.Numerics.Vector4(clear.r, clear.g, clear.b, clear.a);
        var colors = new ColorTarget[Colors.Length];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = new ColorTarget(Colors[i])
            {
                Load = colorLoad,
                Clear = color,
                MipLevel = MipLevel,
                Slice = Slice,
                Resolve = i < Resolves.Length ? Resolves[i] : null,
            };
        }

        return new RenderTargets
        {
            Colors = colors,
            Depth = Depth is null ? null : new DepthTarget(Depth) { Load = depthLoad, Clear = clearDepth, Slice = Slice },
            Viewport = viewport,
        };
    }
}
