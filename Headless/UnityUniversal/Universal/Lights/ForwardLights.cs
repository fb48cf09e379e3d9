using System;
using Unity.Collections;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The variables of lights, and each object's list of them or, in Forward+, the clusters'.</summary>
internal sealed class ForwardLights(bool isClustered) : IDisposable
{
    private static readonly int MainPosition = Shader.PropertyToID("_MainLightPosition");
    private static readonly int MainColor = Shader.PropertyToID("_MainLightColor");
    private static readonly int MainProbes = Shader.PropertyToID("_MainLightOcclusionProbes");
    private static readonly int MainLayers = Shader.PropertyToID("_MainLightLayerMask");
    private static readonly int Count = Shader.PropertyToID("_AdditionalLightsCount");
    private static readonly int Positions = Shader.PropertyToID("_AdditionalLightsPosition");
    private static readonly int Colors = Shader.PropertyToID("_AdditionalLightsColor");
    private static readonly int Attenuations = Shader.PropertyToID("_AdditionalLightsAttenuation");
    private static readonly int SpotDirections = Shader.PropertyToID("_AdditionalLightsSpotDir");
    private static readonly int Probes = Shader.PropertyToID("_AdditionalLightsOcclusionProbes");

    private readonly Vector4[] positions = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
    private readonly Vector4[] colors = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
    private readonly Vector4[] attenuations = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
    private readonly Vector4[] directions = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
    private readonly Vector4[] probes = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
    private readonly LightClusters? clusters = isClustered ? new LightClusters() : null;

    public bool IsClustered => clusters is not null;

    public void Record(RenderGraph graph, ContextContainer frame)
    {
        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("Setup Forward Lights", out Data data);
        (data.Lights, data.Camera) = (frame.Get<UniversalLightData>(), frame.Get<UniversalCameraData>());
        (data.Results, data.Owner) = (frame.Get<UniversalRenderingData>().cullResults, this);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, UnsafeGraphContext context) => d.Owner.Set(context.cmd, d));
    }

    public void Dispose() => clusters?.Dispose();

    private void Set(UnsafeCommandBuffer cmd, Data data)
    {
        UniversalLightData lights = data.Lights;
        clusters?.Set(cmd, data.Camera, lights, data.Results);
        SetMain(cmd, lights);
        SetAdditional(cmd, lights, data.Results);
        bool counts = lights.supportsAdditionalLights;
        cmd.SetKeyword(RenderingKeywords.AdditionalLightsVertex, counts && lights.shadeAdditionalLightsPerVertex && !IsClustered);
        cmd.SetKeyword(RenderingKeywords.AdditionalLightsPixel, counts && !lights.shadeAdditionalLightsPerVertex && !IsClustered);
        cmd.SetKeyword(RenderingKeywords.ForwardPlus, IsClustered);
        cmd.SetKeyword(RenderingKeywords.ClusterLightLoop, IsClustered);
        cmd.SetKeyword(RenderingKeywords.ReflectionProbeBlending, lights.reflectionProbeBlending);
        cmd.SetKeyword(RenderingKeywords.ReflectionProbeBoxProjection, lights.reflectionProbeBoxProjection);
        cmd.SetKeyword(RenderingKeywords.LightLayers, lights.supportsLightLayers);
    }

    private static void SetMain(UnsafeCommandBuffer cmd, UniversalLightData lights)
    {
        LightConstants main = lights.mainLightIndex < 0 ? LightConstants.None : LightConstants.Of(lights.visibleLights[lights.mainLightIndex]);
        cmd.SetGlobalVector(MainPosition, main.Position);
        cmd.SetGlobalVector(MainColor, new Vector4(main.Color.x, main.Color.y, main.Color.z, 1f));
        cmd.SetGlobalVector(MainProbes, Vector4.zero);
        if (lights.supportsLightLayers && lights.mainLightIndex >= 0)
        {
            cmd.SetGlobalInt(MainLayers, lights.visibleLights[lights.mainLightIndex].light.renderingLayerMask);
        }
    }

    private void SetAdditional(UnsafeCommandBuffer cmd, UniversalLightData lights, CullingResults results)
    {
        if (lights.additionalLightsCount == 0)
        {
            cmd.SetGlobalVector(Count, Vector4.zero);
            return;
        }

        int next = 0;
        for (int i = 0; i < lights.visibleLights.Length && next < positions.Length; i++)
        {
            if (i != lights.mainLightIndex)
            {
                LightConstants light = LightConstants.Of(lights.visibleLights[i]);
                (positions[next], colors[next], attenuations[next], directions[next]) = (light.Position, light.Color, light.Attenuation, light.SpotDirection);
                colors[next].w = 0f;
                next++;
            }
        }

        if (!IsClustered)
        {
            NumberPerObject(lights, results);
        }

        cmd.SetGlobalVectorArray(Positions, positions);
        cmd.SetGlobalVectorArray(Colors, colors);
        cmd.SetGlobalVectorArray(Attenuations, attenuations);
        cmd.SetGlobalVectorArray(SpotDirections, directions);
        cmd.SetGlobalVectorArray(Probes, probes);
        cmd.SetGlobalVector(Count, new Vector4(lights.maxPerObjectAdditionalLightsCount, 0f, 0f, 0f));
    }

    /// <summary>Objects list additional lights by their place in the arrays, and not the main light.</summary>
    private static void NumberPerObject(UniversalLightData lights, CullingResults results)
    {
        NativeArray<int> map = results.GetLightIndexMap(Allocator.Temp);
        int left = 0;
        for (int i = 0; i < map.Length; i++)
        {
            bool isAdditional = i != lights.mainLightIndex && i < lights.visibleLights.Length && i - left < UniversalRenderPipeline.maxVisibleAdditionalLights
                && lights.visibleLights[i].lightType is LightType.Directional or LightType.Spot or LightType.Point;
            left += i == lights.mainLightIndex ? 1 : 0;
            map[i] = isAdditional ? map[i] - left : -1;
        }

        results.SetLightIndexMap(map);
        map.Dispose();
    }

    private sealed class Data
    {
        public ForwardLights Owner { get; set; } = null!;
        public UniversalLightData Lights { get; set; } = null!;
        public UniversalCameraData Camera { get; set; } = null!;
        public CullingResults Results { get; set; }
    }
}
