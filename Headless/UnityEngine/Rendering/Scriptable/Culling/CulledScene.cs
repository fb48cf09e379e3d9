using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>What one culling found; its lists are made when they are first asked for.</summary>
internal sealed class CulledScene
{
    private readonly List<DrawRequest> drawn;
    private readonly Dictionary<int, ShadowCasters> shadows = [];
    private readonly Frustum frustum;
    private readonly bool castsShadows;

    public CulledScene(in ScriptableCullingParameters parameters)
    {
        View = parameters.View;
        frustum = CameraCulling.Planes(parameters);
        ShadowDistance = Mathf.Min(parameters.shadowDistance, View.Far);
        castsShadows = (parameters.cullingOptions & CullingOptions.ShadowCasters) != 0;
        Camera? camera = parameters.Camera;
        int mask = (int)parameters.cullingMask;
        drawn = SceneDraws.Collect().FindAll(d => d.Material != null && d.SeenBy(camera, mask));
        Visible = [];
        foreach (DrawRequest draw in drawn)
        {
            float limit = parameters.GetLayerCullingDistance(draw.Layer);
            if (draw.IsVisible && frustum.Touches(draw.Bounds) && (limit <= 0f || draw.Bounds.SqrDistance(parameters.origin) <= limit * limit))
            {
                Visible.Add(draw);
            }
        }

        bool lit = (parameters.cullingOptions & CullingOptions.NeedsLighting) != 0;
        Lights = new CulledLights(lit ? LightList.All.Where(LightList.IsDrawn) : [], frustum, View, parameters.maximumVisibleLights);
        bool mirrors = (parameters.cullingOptions & CullingOptions.NeedsReflectionProbes) != 0;
        Probes = new CulledProbes(mirrors ? ReflectionProbeList.All : [], frustum, parameters.reflectionProbeSortingCriteria);
    }

    public CameraView View { get; }
    public float ShadowDistance { get; }
    public List<DrawRequest> Visible { get; }
    public CulledLights Lights { get; }
    public CulledProbes Probes { get; }
    public int LightIndexCount => Visible.Sum(d => Lights.Of(d).Count);
    public int ProbeIndexCount => Visible.Sum(d => Probes.Count(d));

    /// <summary>The casters of a visible light.</summary>
    public ShadowCasters Shadows(int lightIndex)
    {
        if (!shadows.TryGetValue(lightIndex, out ShadowCasters? casters))
        {
            Light light = Lights[lightIndex];
            Vector3 end = View.Position + (View.Forward * ShadowDistance);
            Vector3 back = -View.Forward;
            Frustum seen = frustum.Before(new Vector4(back.x, back.y, back.z, -Vector3.Dot(back, end)));
            casters = new ShadowCasters(light, castsShadows ? drawn : [], seen);
            shadows.Add(lightIndex, casters);
        }

        return casters;
    }
}
