using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The targets of a camera while it draws.</summary>
/// <param name="target">What the scene is drawn into.</param>
/// <param name="intermediate">The texture behind it when image effects or a part of the screen need one.</param>
internal sealed class CameraFrame(DrawTarget target, RenderTexture? intermediate) : IDisposable
{
    public DrawTarget Target { get; } = target;
    public RenderTexture? Intermediate { get; } = intermediate;

    public NamedTemporaries Temporaries { get; } = new();

    public void Dispose()
    {
        Temporaries.Dispose();
        RenderTexture.ReleaseTemporary(Intermediate!);
    }
}
