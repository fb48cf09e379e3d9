using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Shadows of spot lights, one square each, and of point lights, six each, in one atlas of equal squares.</summary>
internal sealed class AdditionalLightsShadowPass
{
    private const int Smallest = 16;

    private static readonly int Map = Shader.PropertyToID("_AdditionalLightsShadowmapTexture");
    private static readonly int WorldToShadow = Shader.PropertyToID("_AdditionalLightsWorldToShadow");
    private static readonly int Params = Shader.PropertyToID("_AdditionalShadowParams");
    private static readonly int Fade = Shader.PropertyToID("_AdditionalShadowFadeParams");
    private static readonly int Size = Shader.PropertyToID("_AdditionalShadowmapSize");
    private static readonly int Offset0 = Shader.PropertyToID("_AdditionalShadowOffset0");
    private static readonly int Offset1 = Shader.PropertyToID("_AdditionalShadowOffset1");

    /// <summary>False where no light casts, and nothing was recorded.</summary>
    public bool Record(RenderGraph graph, ContextContainer frame)
    {
        UniversalShadowData shadows = frame.Get<UniversalShadowData>();
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        if (!UniversalRenderPipeline.asset!.supportsAdditionalLightShadows || camera.maxShadowDistance <= 0f)
        {
            return false;
        }

        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Additional Lights Shadowmap", out Data data);
        (data.Width, data.Height) = (shadows.additionalLightsShadowmapWidth, shadows.additionalLightsShadowmapHeight);
        (data.Distance, data.Border) = (camera.maxShadowDistance, shadows.mainLightShadowCascadeBorder);
        Fit(data, graph, builder, frame);
        TextureHandle map = graph.CreateTexture(new TextureDesc(data.Slices.Count > 0 ? data.Width : 1, data.Slices.Count > 0 ? data.Height : 1)
        {
            format = GraphicsFormat.D32_SFloat,
            isShadowMap = true,
            filterMode = FilterMode.Bilinear,
            clearBuffer = true,
            name = "_AdditionalLightsShadowmapTexture",
        });
        frame.Get<UniversalResourceData>().additionalShadowsTexture = map;
        builder.SetRenderAttachmentDepth(map, AccessFlags.ReadWrite);
        builder.SetGlobalTextureAfterPass(map, Map);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, RasterGraphContext context) => Draw(context.cmd, d));
        return true;
    }

    private static void Fit(Data data, RenderGraph graph, IRasterRenderGraphBuilder builder, ContextContainer frame)
    {
        UniversalShadowData shadows = frame.Get<UniversalShadowData>();
        UniversalLightData lights = frame.Get<UniversalLightData>();
        CullingResults results = frame.Get<UniversalRenderingData>().cullResults;
        NativeArray<VisibleLight> visible = lights.visibleLights;
        var casting = new List<(int Visible, int Additional)>();
        int wanted = 0;
        for (int i = 0, additional = 0; i < visible.Length; i++)
        {
            if (i == lights.mainLightIndex)
            {
                continue;
            }

            int slices = visible[i].lightType switch { LightType.Spot => 1, LightType.Point => 6, _ => 0 };
            if (slices > 0 && visible[i].light.shadows != LightShadows.None && visible[i].light.shadowStrength > 0f && results.GetShadowCasterBounds(i, out _))
            {
                casting.Add((i, additional));
                wanted += slices;
            }

            additional++;
        }

        data.Params = new Vector4[UniversalRenderPipeline.maxVisibleAdditionalLights];
        Array.Fill(data.Params, new Vector4(0f, 0f, 0f, -1f));
        int resolution = Math.Min(data.Width, data.Height);
        while (wanted > 0 && data.Width / resolution * (data.Height / resolution) < wanted && resolution > Smallest)
        {
            resolution >>= 1;
        }

        foreach ((int index, int additional) in casting)
        {
            bool isPoint = visible[index].lightType == LightType.Point;
            Light light = visible[index].light;
            bool isSoft = light.shadows == LightShadows.Soft && UniversalRenderPipeline.asset!.supportsSoftShadows;
            data.Params[additional] = new Vector4(light.shadowStrength, ShadowSlice.Softness(light, isSoft), isPoint ? 1f : 0f, data.Slices.Count);
            data.IsSoft |= isSoft;
            for (int face = 0; face < (isPoint ? 6 : 1); face++)
            {
                Add(data, graph, builder, results, visible[index], index, face, resolution, shadows.bias[index]);
            }
        }
    }

    private static void Add(
        Data data, RenderGraph graph, IRasterRenderGraphBuilder builder, CullingResults results, in VisibleLight light, int index, int face, int resolution, Vector4 bias)
    {
        Matrix4x4 view;
        Matrix4x4 projection;
        ShadowSplitData split;
        if (light.lightType == LightType.Point)
        {
            results.ComputePointShadowMatricesAndCullingPrimitives(index, (CubemapFace)face, 0f, out view, out projection, out split);
            view.SetRow(1, -view.GetRow(1));
        }
        else
        {
            results.ComputeSpotShadowMatricesAndCullingPrimitives(index, out view, out projection, out split);
        }

        int perRow = data.Width / resolution;
        int place = data.Slices.Count;
        var slice = new ShadowSlice(view, projection, split, place % perRow * resolution, place / perRow * resolution, resolution);
        var settings = new ShadowDrawingSettings(results, index, BatchCullingProjectionType.Perspective) { splitData = split };
        RendererListHandle casters = graph.CreateShadowRendererList(ref settings);
        builder.UseRendererList(casters);
        data.Slices.Add((slice, light, casters, bias));
    }

    private static void Draw(RasterCommandBuffer cmd, Data data)
    {
        cmd.SetKeyword(RenderingKeywords.CastingPunctualLight, data.Slices.Count > 0);
        foreach ((ShadowSlice slice, VisibleLight light, RendererListHandle casters, Vector4 bias) in data.Slices)
        {
            ShadowSlice.SetCaster(cmd, light, slice.Bias(light, bias, data.IsSoft));
            slice.Draw(cmd, casters);
        }

        cmd.SetKeyword(RenderingKeywords.AdditionalLightShadows, true);
        (float scale, float fade) = ShadowSlice.Fade(data.Distance * data.Distance, data.Border);
        cmd.SetGlobalVectorArray(Params, data.Params);
        cmd.SetGlobalVector(Fade, new Vector4(scale, fade, 0f, 0f));
        if (data.Slices.Count == 0)
        {
            return;
        }

        cmd.SetGlobalMatrixArray(WorldToShadow, [.. data.Slices.ConvertAll(s => s.Slice.WorldToAtlas(data.Width, data.Height))]);
        if (data.IsSoft)
        {
            (float x, float y) = (1f / data.Width, 1f / data.Height);
            cmd.SetKeyword(RenderingKeywords.SoftShadows, true);
            cmd.SetGlobalVector(Offset0, new Vector4(-x, -y, x, -y) * 0.5f);
            cmd.SetGlobalVector(Offset1, new Vector4(-x, y, x, y) * 0.5f);
            cmd.SetGlobalVector(Size, new Vector4(x, y, data.Width, data.Height));
        }
    }

    private sealed class Data
    {
        public int Width { get; set; }
        public int Height { get; set; }
        public float Distance { get; set; }
        public float Border { get; set; }
        public bool IsSoft { get; set; }
        public Vector4[] Params { get; set; } = [];
        public List<(ShadowSlice Slice, VisibleLight Light, RendererListHandle Casters, Vector4 Bias)> Slices { get; } = [];
    }
}
