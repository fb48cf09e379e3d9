using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The shadow map of the main directional light: depth from the light over a sphere around the casters.</summary>
internal sealed class ShadowMap
{
    private const int Size = 2048;
    private RenderTexture? texture;

    /// <summary>False when nothing casts shadows; receivers then see an empty map.</summary>
    public bool Render(Camera camera, List<DrawRequest> all)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        texture = texture != null ? texture : Make();
        sheet.SetTexture(BuiltinNames.ShadowMap, new TextureSlot(texture, 0, RenderTextureSubElement.Depth));
        Light? light = LightList.Main;
        if (light == null || light.shadows == LightShadows.None || QualitySettings.shadows == ShadowQuality.Disable)
        {
            sheet.SetVector(BuiltinNames.LightShadowData, new Vector4(1f, 0f, 0f, 0f));
            return false;
        }

        var casters = all.FindAll(d =>
            d.Material != null && d.CastsShadows && (light.cullingMask & (1 << d.Layer)) != 0
            && (d.Camera is null || ReferenceEquals(d.Camera, camera)) && PassSelection.ShadowPass(d.Material) is not null);
        if (casters.Count == 0)
        {
            sheet.SetVector(BuiltinNames.LightShadowData, new Vector4(1f, 0f, 0f, 0f));
            return false;
        }

        ShadowVolume volume = ShadowVolume.Around(casters, camera, light.transform, Size);
        sheet.SetVector(BuiltinNames.LightShadowData, new Vector4(1f - light.shadowStrength, 0f, 0f, 0f));
        float texel = volume.Width / Size;
        sheet.SetVector(
            BuiltinNames.LightShadowBias,
            new Vector4(-Mathf.Min(light.shadowBias, texel * 2f) / volume.Depth, 1f, light.shadowNormalBias * texel, 0f));

        TargetState.Set(DrawTarget.Of(texture));
        TargetState.Clear(false, true, default, 0f);
        ViewState.Set(volume.View, volume.Projection);
        foreach (DrawRequest caster in casters)
        {
            PassSelection.DrawShadow(caster);
        }

        TargetState.Finish();
        Matrix4x4 worldToShadow = volume.WorldToShadow(texel * 1.5f);
        sheet.SetMatrices(BuiltinNames.WorldToShadow, [worldToShadow, worldToShadow, worldToShadow, worldToShadow]);
        return true;
    }

    public void Reset() => texture = null;

    private static RenderTexture Make() => new(Size, Size, 32, RenderTextureFormat.Shadowmap)
    {
        name = "Shadow map",
        filterMode = FilterMode.Bilinear,
        wrapMode = TextureWrapMode.Clamp,
        hideFlags = HideFlags.HideAndDontSave,
    };
}
