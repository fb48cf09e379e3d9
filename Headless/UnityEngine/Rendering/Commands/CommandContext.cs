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

    public DrawTarget? Target(in RenderTargetIdentifier id)
    {
        if (id.Builtin is BuiltinRenderTextureType.CameraTarget)
        {
            return cameraTarget ?? DrawTarget.Screen;
        }

        if (id.Builtin is BuiltinRenderTextureType.CurrentActive)
        {
            return TargetState.Current;
        }

        if (Texture(id) is RenderTexture texture)
        {
            return DrawTarget.Of(texture, id.MipLevel, Math.Max(0, id.Slice));
        }

        Debug.LogError($"CommandBuffer: render target {id} is not set or is no render texture.");
        return null;
    }

    public Texture? Texture(in RenderTargetIdentifier id) => id.Texture
        ?? (id.Builtin == BuiltinRenderTextureType.PropertyName
            ? temporaries.Find(id.NameId) ?? GlobalProperties.Sheet.Textures.GetValueOrDefault(id.NameId).Texture
            : null);

    public void BeginSample(string name) => samples.Push((name, GraphicsDevice.Recorder.BeginTimer(name)));

    public void EndSample(string name)
    {
        if (samples.Count == 0 || samples.Peek().Name != name)
        {
            Debug.LogError($"CommandBuffer: EndSample(\"{name}\") has no BeginSample of that name directly before it.");
            return;
        }

        GraphicsDevice.Recorder.EndTimer(samples.Pop().Timer);
    }

    /// <summary>Closes samples that the commands left open.</summary>
    public void Finish()
    {
        while (samples.TryPop(out (string Name, int Timer) sample))
        {
            Debug.LogError($"CommandBuffer: BeginSample(\"{sample.Name}\") has no EndSample.");
            GraphicsDevice.Recorder.EndTimer(sample.Timer);
        }
    }
}
