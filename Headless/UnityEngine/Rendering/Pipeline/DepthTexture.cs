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

        bool both = EyeViews.Camera is not null;
        TextureDimension dimension = both ? TextureDimension.Tex2DArray : TextureDimension.Tex2D;
        if (texture == null || texture.width != camera.pixelWidth || texture.height != camera.pixelHeight || texture.dimension != dimension)
        {
            texture?.Release();
            texture = new RenderTexture(camera.pixelWidth, camera.pixelHeight, 32, RenderTextureFormat.Depth)
            {
                name = "Camera depth texture",
                dimension = dimension,
                volumeDepth = both ? 2 : 1,
                filterMode = FilterMode.Point,
                hideFlags = HideFlags.HideAndDontSave,
            };
        }

        TargetState.Set(DrawTarget.Of(texture, 0, RenderTargetIdentifier.AllDepthSlices));
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
