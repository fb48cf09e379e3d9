using System.Linq;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The target being drawn to; drawing begins with the first draw, so that a clear before it costs nothing.</summary>
internal static class TargetState
{
    private static DrawTarget? target;
    private static bool open;
    private static bool clearColor;
    private static bool clearDepth;
    private static Color color;
    private static float depth;
    private static GpuViewport? viewport;
    private static RectInt? scissor;

    public static DrawTarget? Current => target;

    public static void Set(DrawTarget? value)
    {
        Finish();
        target = value;
        viewport = null;
        scissor = null;
    }

    public static void Clear(bool clearColors, bool clearDepths, Color toColor, float toDepth)
    {
        if (target is null)
        {
            return;
        }

        if (open)
        {
            GraphicsDevice.Recorder.EndRendering();
            open = false;
        }

        if (clearColors)
        {
            (clearColor, color) = (true, toColor);
        }

        if (clearDepths)
        {
            (clearDepth, depth) = (true, toDepth);
        }
    }

    /// <summary>Content that nobody cares for is undefined: on a device that poisons, it is poisoned.</summary>
    public static void Discard(bool colors, bool depths)
    {
        if (MemoryPoison.Enabled && (colors || depths) && target is not null)
        {
            bool fractions = target.Colors.Any(t => t.Description.Format is GpuFormat.R8Unorm or GpuFormat.R8G8Unorm
                or GpuFormat.R8G8B8A8Unorm or GpuFormat.R8G8B8A8Srgb);
            float poison = fractions ? 1f : float.NaN;
            Clear(colors, depths, new Color(poison, poison, poison, poison), 1f);
        }
    }

    /// <param name="rect">Origin at the bottom left of the picture; null for the whole target.</param>
    public static void SetViewport(Rect? rect)
    {
        viewport = rect is { } r && target is not null ? target.Viewport(r) : null;
        if (open)
        {
            GraphicsDevice.Recorder.SetViewport(viewport ?? Whole());
        }
    }

    public static void SetScissor(Rect? rect)
    {
        scissor = rect is { } r && target is not null
            ? new RectInt((int)r.x, (int)(target.Flipped ? r.y : target.Height - r.yMax), (int)r.width, (int)r.height)
            : null;
        if (open)
        {
            ApplyScissor();
        }
    }

    public static void Begin()
    {
        if (open || target is null)
        {
            return;
        }

        open = true;
        GraphicsDevice.Recorder.BeginRendering(target.Begin(
            clearColor ? TargetLoad.Clear : TargetLoad.Load, color, clearDepth ? TargetLoad.Clear : TargetLoad.Load, depth, viewport));
        (clearColor, clearDepth) = (false, false);
        if (scissor is not null)
        {
            ApplyScissor();
        }
    }

    /// <summary>Ends drawing, carrying out a clear that nothing was drawn after.</summary>
    public static void Finish()
    {
        if (target is null)
        {
            return;
        }

        if (clearColor || clearDepth)
        {
            Begin();
        }

        if (open)
        {
            GraphicsDevice.Recorder.EndRendering();
            open = false;
        }
    }

    public static void Reset()
    {
        target = null;
        (open, clearColor, clearDepth) = (false, false, false);
        (viewport, scissor) = (null, null);
    }

    private static GpuViewport Whole() => new(0f, 0f, target!.Width, target.Height);

    private static void ApplyScissor()
    {
        RectInt r = scissor ?? new RectInt(0, 0, target!.Width, target.Height);
        GraphicsDevice.Recorder.SetScissor(r.x, r.y, r.width, r.height);
    }
}
