using System.Collections.Generic;
using System.Linq;
using System;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What commands see while a command buffer runs: the camera's target, temporary textures, open samples.</summary>
internal sealed class CommandContext(DrawTarget? cameraTarget, NamedTemporaries temporaries)
{
    private readonly Stack<(string Name, int Timer)> samples = [];

    public NamedTemporaries Temporaries => temporaries;

    /// <summary>Of the camera that draws; null for the screen.</summary>
    public DrawTarget? CameraTarget { get; set; } = cameraTarget;

    /// <summary>In a scriptable pipeline the one that was set up last.</summary>
    public Camera? Camera { get; set; }

    public DrawTarget? Target(in RenderTargetIdentifier id)
    {
        if (id.Builtin is BuiltinRenderTextureType.CameraTarget)
        {
            return CameraTarget ?? DrawTarget.Screen;
        }

        if (id.Builtin is BuiltinRenderTextureType.Depth)
        {
            DrawTarget whole = CameraTarget ?? DrawTarget.Screen;
            return new DrawTarget { Depth = whole.Depth, Slice = whole.Slice, Flipped = whole.Flipped };
        }

        if (id.Builtin is BuiltinRenderTextureType.None)
        {
            return null;
        }

        if (id.Builtin is BuiltinRenderTextureType.CurrentActive)
        {
            return TargetState.Current;
        }

        if (Texture(id) is RenderTexture texture)
        {
            return DrawTarget.Of(texture, id.MipLevel, id.Slice);
        }

        Debug.LogError($"CommandBuffer: render target {id} is not set or is no render texture.");
        return null;
    }

    /// <summary>Several colors, and a depth of its own; null where there are neither.</summary>
    public DrawTarget? Target(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth)
    {
        DrawTarget[] targets = [.. colors.Select(id => Target(id)).OfType<DrawTarget>()];
        DrawTarget? depths = Target(depth);
        return targets.Length == 0 ? depths : new DrawTarget
        {
            Colors = [.. targets.SelectMany(t => t.Colors)],
            Resolves = [.. targets.SelectMany(t => t.Resolves)],
            Depth = depths?.Depth,
            MipLevel = targets[0].MipLevel,
            Slice = targets[0].Slice,
            Flipped = targets[0].Flipped,
        };
    }

    public Texture? Texture(in RenderTargetIdentifier id) => id.Texture
        ?? (id.Builtin == BuiltinRenderTextureType.PropertyName
            ? temporaries.Find(id.NameId) ?? GlobalProperties.Sheet.Textures.GetValueOrDefault(id.NameId).Texture
            : null);

    public void SendRenderObject()
    {
        Camera? before = UnityEngine.Camera.current;
        UnityEngine.Camera.current = Camera;
        CameraMessages.SendToAll("OnRenderObject");
        UnityEngine.Camera.current = before;
    }

    public void BeginSample(string name) => samples.Push((name, GpuTimings.Begin(name)));

    public void EndSample(string name)
    {
        if (samples.Count == 0 || samples.Peek().Name != name)
        {
            Debug.LogError($"CommandBuffer: EndSample(\"{name}\") has no BeginSample of that name directly before it.");
            return;
        }

        GpuTimings.End(samples.Pop().Timer);
    }

    /// <summary>Closes samples that the commands left open.</summary>
    public void Finish()
    {
        while (samples.TryPop(out (string Name, int Timer) sample))
        {
            Debug.LogError($"CommandBuffer: BeginSample(\"{sample.Name}\") has no EndSample.");
            GpuTimings.End(sample.Timer);
        }
    }
}
