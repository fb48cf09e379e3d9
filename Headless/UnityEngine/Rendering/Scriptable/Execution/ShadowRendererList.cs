using System.Linq;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The ShadowCaster passes of what shades the view.</summary>
internal sealed class ShadowRendererList(ContextCommands owner, CulledScene scene, ShadowDrawingSettings settings) : RendererListContent(owner)
{
    private DrawRequest[]? casters;

    public override bool IsEmpty => Casters.Length == 0;

    private DrawRequest[] Casters => casters ??= [.. scene.Shadows(settings.lightIndex).Of(settings)];

    public override void Prepare() => _ = Casters;

    public override void Draw()
    {
        foreach (DrawRequest caster in Casters)
        {
            PassSelection.DrawShadow(caster);
        }
    }
}
