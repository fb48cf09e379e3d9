using System;
using Unity.Collections;

namespace UnityEngine.Rendering.Universal;

/// <summary>The lights and shadows that a camera sees.</summary>
internal static class LightSetup
{
    public static void Fill(ContextContainer frame, UniversalRenderPipelineAsset settings, ScriptableRenderer renderer, CullingResults results)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalLightData lights = frame.Create<UniversalLightData>();
        lights.visibleLights = results.visibleLights;
        lights.mainLightIndex = settings.mainLightRenderingMode == LightRenderingMode.PerPixel ? Brightest(lights.visibleLights) : -1;
        lights.supportsAdditionalLights = settings.additionalLightsRenderingMode != LightRenderingMode.Disabled;
        lights.shadeAdditionalLightsPerVertex = settings.additionalLightsRenderingMode == LightRenderingMode.PerVertex;
        lights.supportsMixedLighting = settings.supportsMixedLighting;
        lights.supportsLightLayers = settings.useRenderingLayers;
        (lights.reflectionProbeBlending, lights.reflectionProbeBoxProjection) = (settings.reflectionProbeBlending, settings.reflectionProbeBoxProjection);
        if (lights.supportsAdditionalLights)
        {
            int others = lights.visibleLights.Length - (lights.mainLightIndex >= 0 ? 1 : 0);
            lights.additionalLightsCount = Math.Min(others, UniversalRenderPipeline.maxVisibleAdditionalLights);
            lights.maxPerObjectAdditionalLightsCount = Math.Min(settings.maxAdditionalLightsCount, UniversalRenderPipeline.maxPerObjectLights);
        }

        FillShadows(frame.Create<UniversalShadowData>(), settings, camera, lights);
        UniversalRenderingData rendering = frame.Create<UniversalRenderingData>();
        rendering.cullResults = results;
        rendering.supportsDynamicBatching = settings.supportsDynamicBatching;
        renderer.Describe(rendering);
        rendering.perObjectData = PerObject(rendering, lights);
    }

    private static void FillShadows(UniversalShadowData shadows, UniversalRenderPipelineAsset settings, UniversalCameraData camera, UniversalLightData lights)
    {
        shadows.MainLightShadowsEnabled = settings.supportsMainLightShadows && settings.mainLightRenderingMode == LightRenderingMode.PerPixel;
        bool isCast = lights.mainLightIndex >= 0 && lights.visibleLights[lights.mainLightIndex].light.shadows != LightShadows.None;
        shadows.supportsMainLightShadows = shadows.MainLightShadowsEnabled && camera.maxShadowDistance > 0f && isCast;
        shadows.supportsSoftShadows = settings.supportsSoftShadows && shadows.supportsMainLightShadows;
        (shadows.mainLightShadowmapWidth, shadows.mainLightShadowmapHeight) = (settings.mainLightShadowmapResolution, settings.mainLightShadowmapResolution);
        (shadows.additionalLightsShadowmapWidth, shadows.additionalLightsShadowmapHeight) =
            (settings.additionalLightsShadowmapResolution, settings.additionalLightsShadowmapResolution);
        shadows.mainLightShadowCascadesCount = settings.shadowCascadeCount;
        shadows.mainLightShadowCascadesSplit = settings.CascadeSplit();
        shadows.mainLightShadowCascadeBorder = settings.cascadeBorder;
        shadows.shadowmapDepthBufferBits = 16;
        foreach (VisibleLight visible in lights.visibleLights)
        {
            bool isOwn = visible.light != null && visible.light.TryGetComponent(out UniversalAdditionalLightData data) && !data.usePipelineSettings;
            shadows.bias.Add(isOwn
                ? new Vector4(visible.light!.shadowBias, visible.light.shadowNormalBias, 0f, 0f)
                : new Vector4(settings.shadowDepthBias, settings.shadowNormalBias, 0f, 0f));
        }
    }

    private static PerObjectData PerObject(UniversalRenderingData rendering, UniversalLightData lights)
    {
        PerObjectData data = PerObjectData.Lightmaps | PerObjectData.LightProbe | PerObjectData.OcclusionProbe | PerObjectData.ShadowMask;
        if (rendering.renderingMode == RenderingMode.ForwardPlus)
        {
            return lights.reflectionProbeBlending ? data : data | PerObjectData.ReflectionProbes;
        }

        data |= PerObjectData.ReflectionProbes | PerObjectData.LightData;
        return lights.additionalLightsCount > 0 ? data | PerObjectData.LightIndices : data;
    }

    /// <summary>RenderSettings.sun where it is seen, else the brightest directional light; -1 without one.</summary>
    private static int Brightest(NativeArray<VisibleLight> lights)
    {
        Light? sun = RenderSettings.sun;
        int brightest = -1;
        float intensity = 0f;
        for (int i = 0; i < lights.Length; i++)
        {
            Light light = lights[i].light;
            if (light == null)
            {
                break;
            }

            if (lights[i].lightType != LightType.Directional)
            {
                continue;
            }

            if (light == sun)
            {
                return i;
            }

            if (light.intensity > intensity)
            {
                (brightest, intensity) = (i, light.intensity);
            }
        }

        return brightest;
    }
}
