using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>_CameraDepthTexture: the scene's depth before shading, drawn with the ShadowCaster passes as in Unity.</summary>
internal sealed class DepthTexture
{
    private RenderTexture? texture;

    public void Render(Camera camera, List<VisibleDraw> visible)
    {
        if ((camera.depthTextureMode & DepthTextureMode.Depth) == 0)
        {
            return;
        }

        if (texture == null || texture.width != camera.pixelWidth || texture.height != camera.pixelHeight)
        {
            texture?.Release();
            texture = new RenderTexture(camera.pixelWidth, camera.pixelHeight, 32, RenderTextureFormat.Depth)
            {
                name = "Camera depth texture",
                filterMode = FilterMode.Point,
                hideFlags = HideFlags.HideAndDontSave,
            };
        }

        TargetState.Set(DrawTarget.Of(texture));
        TargetState.Clear(false, true, default, 0f);
        GlobalProperties.Sheet.SetVector(BuiltinNames.LightShadowBias, default);
        CameraSettings.Apply(camera);
        foreach (VisibleDraw draw in SceneDraws.Opaque(visible))
        {
            PassSelection.DrawShadow(draw.Request);
        }

        TargetState.Finish();
        GlobalProperties.Sheet.SetTexture(BuiltinNames.CameraDepthTexture, new TextureSlot(texture, 0, RenderTextureSubElement.Depth));
    }

    public void Reset() => texture = null;
}
