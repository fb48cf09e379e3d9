using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The things whose shadow from one light may be seen; they may lie outside the view.</summary>
internal sealed class ShadowCasters
{
    private readonly Light light;
    private readonly List<DrawRequest> casters;

    /// <param name="seen">What the camera sees up to its shadow distance.</param>
    public ShadowCasters(Light light, List<DrawRequest> drawn, Frustum seen)
    {
        this.light = light;
        Vector3 along = light.transform.forward;
        casters = light.shadows == LightShadows.None ? [] : drawn.FindAll(d =>
            d.CastsShadows && ObjectLights.Reaches(light, d) && (light.type != LightType.Directional || seen.Touches(d.Bounds, along))
            && PassSelection.ShadowPass(d.Material) is not null);
    }

    public bool Bounds(out Bounds bounds)
    {
        bounds = casters.Count > 0 ? casters[0].Bounds : default;
        foreach (DrawRequest caster in casters)
        {
            bounds.Encapsulate(caster.Bounds);
        }

        return casters.Count > 0;
    }

    /// <summary>Those that a list draws: of a cascade, what may lie between its sphere and the light.</summary>
    public IEnumerable<DrawRequest> Of(ShadowDrawingSettings settings)
    {
        Vector4 sphere = settings.splitData.cullingSphere;
        return casters.Where(c =>
            (!settings.useRenderingLayerMaskTest || (c.RenderingLayers & (uint)light.renderingLayerMask) != 0)
            && (light.type != LightType.Directional || sphere.w <= 0f || MayShade(c.Bounds, sphere, sphere.w)));
    }

    private bool MayShade(in Bounds caster, Vector3 center, float radius)
    {
        Vector3 to = caster.center - center;
        float reach = caster.extents.magnitude + radius;
        float along = Vector3.Dot(to, light.transform.forward);
        return along <= reach && to.sqrMagnitude - (along * along) <= reach * reach;
    }
}
