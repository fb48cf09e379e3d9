using System.Collections.Generic;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The shadow map of the main directional light: depth from the light over a sphere around the casters.</summary>
internal sealed class ShadowMap
{
    private const int Size = 2048;
    private RenderTexture? texture;
    private RenderTexture? mask;

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

        DrawTarget map = DrawTarget.Of(texture);
        TargetState.Set(map);
        TargetState.Clear(false, true, default, 0f);
        ViewState.Set(volume.View, volume.Projection);
        Run(light, LightEvent.BeforeShadowMap, map);
        Run(light, LightEvent.BeforeShadowMapPass, map);
        ViewState.Set(volume.View, volume.Projection);
        foreach (DrawRequest caster in casters)
        {
            PassSelection.DrawShadow(caster);
        }

        TargetState.Finish();
        Run(light, LightEvent.AfterShadowMapPass, map);
        Run(light, LightEvent.AfterShadowMap, map);

        SetReceiverConstants(camera, volume, texel);
        CameraSettings.Apply(camera);
        if (light.commandBufferCount > 0)
        {
            Run(light, LightEvent.BeforeScreenspaceMask, Mask());
            Run(light, LightEvent.AfterScreenspaceMask, Mask());
        }

        return true;
    }

    /// <summary>Of one map without cascades: the first split is the whole, and nothing is in the others.</summary>
    private static void SetReceiverConstants(Camera camera, ShadowVolume volume, float texel)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        Matrix4x4 worldToShadow = volume.WorldToShadow(texel * 1.5f);
        sheet.SetMatrices(BuiltinNames.WorldToShadow, [worldToShadow, worldToShadow, worldToShadow, worldToShadow]);
        Vector3 center = volume.Center;
        float radius = volume.Radius;
        sheet.SetVectors(BuiltinNames.ShadowSplitSpheres, [new Vector4(center.x, center.y, center.z, radius), default, default, default]);
        sheet.SetVector(BuiltinNames.ShadowSplitSqRadii, new Vector4(radius * radius, 0f, 0f, 0f));
        sheet.SetVector(BuiltinNames.LightSplitsNear, new Vector4(camera.nearClipPlane, float.MaxValue, float.MaxValue, float.MaxValue));
        sheet.SetVector(BuiltinNames.LightSplitsFar, new Vector4(camera.farClipPlane, float.MinValue, float.MinValue, float.MinValue));
        sheet.SetVector(BuiltinNames.ShadowFadeCenterAndType, new Vector4(center.x, center.y, center.z, 1f));
    }

    /// <summary>Runs what scripts have added to a light; whatever it did to the render target does not last.</summary>
    private void Run(Light light, LightEvent when, DrawTarget? target)
    {
        CommandBuffer[] buffers = light.GetCommandBuffers(when);
        if (buffers.Length == 0)
        {
            return;
        }

        DrawTarget? before = TargetState.Current;
        TargetState.Set(target);
        using var temporaries = new NamedTemporaries();
        foreach (CommandBuffer buffer in buffers)
        {
            buffer.Execute(target, temporaries);
        }

        TargetState.Set(before);
    }

    /// <summary>Here shaders read the map itself, and no mask is made of it; scripts find a target of the same kind.</summary>
    private DrawTarget Mask()
    {
        mask = mask != null ? mask : new RenderTexture(16, 16, 0, RenderTextureFormat.R8) { name = "Shadow mask", hideFlags = HideFlags.HideAndDontSave };
        return DrawTarget.Of(mask);
    }

    public void Reset() => (texture, mask) = (null, null);

    private static RenderTexture Make() => new(Size, Size, 32, RenderTextureFormat.Shadowmap)
    {
        name = "Shadow map",
        filterMode = FilterMode.Bilinear,
        wrapMode = TextureWrapMode.Clamp,
        hideFlags = HideFlags.HideAndDontSave,
    };
}
