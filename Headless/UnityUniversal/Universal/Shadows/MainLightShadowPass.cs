using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The main light's shadow map: up to four cascades in one atlas; an empty map where no caster is seen.</summary>
internal sealed class MainLightShadowPass
{
    private const int MaxCascades = 4;

    private static readonly int Map = Shader.PropertyToID("_MainLightShadowmapTexture");
    private static readonly int WorldToShadow = Shader.PropertyToID("_MainLightWorldToShadow");
    private static readonly int Params = Shader.PropertyToID("_MainLightShadowParams");
    private static readonly int Radii = Shader.PropertyToID("_CascadeShadowSplitSphereRadii");
    private static readonly int Size = Shader.PropertyToID("_MainLightShadowmapSize");
    private static readonly int Offset0 = Shader.PropertyToID("_MainLightShadowOffset0");
    private static readonly int Offset1 = Shader.PropertyToID("_MainLightShadowOffset1");
    private static readonly int WorldSpaceCameraPos = Shader.PropertyToID("_WorldSpaceCameraPos");

    private static readonly int[] Spheres =
    [
        Shader.PropertyToID("_CascadeShadowSplitSpheres0"), Shader.PropertyToID("_CascadeShadowSplitSpheres1"),
        Shader.PropertyToID("_CascadeShadowSplitSpheres2"), Shader.PropertyToID("_CascadeShadowSplitSpheres3"),
    ];

    /// <summary>False where the camera has no shadows of the main light at all, and nothing was recorded.</summary>
    public bool Record(RenderGraph graph, ContextContainer frame)
    {
        UniversalShadowData shadows = frame.Get<UniversalShadowData>();
        UniversalLightData lights = frame.Get<UniversalLightData>();
        if (!shadows.MainLightShadowsEnabled)
        {
            return false;
        }

        Data data = new() { Camera = frame.Get<UniversalCameraData>(), Shadows = shadows };
        Light? light = lights.mainLightIndex < 0 ? null : lights.visibleLights[lights.mainLightIndex].light;
        CullingResults results = frame.Get<UniversalRenderingData>().cullResults;
        if (!shadows.supportsMainLightShadows || !results.GetShadowCasterBounds(lights.mainLightIndex, out _) || !Fit(data, results, lights.mainLightIndex))
        {
            RecordEmpty(graph, frame, shadows.supportsMainLightShadows || light?.shadows == LightShadows.None ? light : null);
            return true;
        }

        data.Light = lights.visibleLights[lights.mainLightIndex];
        data.Bias = shadows.bias[lights.mainLightIndex];
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Draw Main Light Shadowmap", out Holder holder);
        holder.Data = data;
        for (int i = 0; i < data.Slices.Length; i++)
        {
            // The bounds of what casts are the light's; the slice leaves out what it cannot see.
            var settings = new ShadowDrawingSettings(results, lights.mainLightIndex, BatchCullingProjectionType.Orthographic) { splitData = data.Slices[i].Split };
            data.Casters[i] = graph.CreateShadowRendererList(ref settings);
            builder.UseRendererList(data.Casters[i]);
        }

        TextureHandle map = graph.CreateTexture(new TextureDesc(data.Width, data.Height)
        {
            format = GraphicsFormat.D32_SFloat,
            isShadowMap = true,
            filterMode = FilterMode.Bilinear,
            clearBuffer = true,
            name = "_MainLightShadowmapTexture",
        });
        frame.Get<UniversalResourceData>().mainShadowsTexture = map;
        builder.SetRenderAttachmentDepth(map, AccessFlags.ReadWrite);
        builder.SetGlobalTextureAfterPass(map, Map);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Holder h, RasterGraphContext context) => Draw(context.cmd, h.Data));
        return true;
    }

    private static bool Fit(Data data, CullingResults results, int lightIndex)
    {
        UniversalShadowData shadows = data.Shadows;
        int cascades = shadows.mainLightShadowCascadesCount;
        int resolution = TileResolution(shadows.mainLightShadowmapWidth, shadows.mainLightShadowmapHeight, cascades);
        (data.Width, data.Height) = (shadows.mainLightShadowmapWidth, cascades == 2 ? shadows.mainLightShadowmapHeight >> 1 : shadows.mainLightShadowmapHeight);
        (data.Slices, data.Casters) = (new ShadowSlice[cascades], new RendererListHandle[cascades]);
        Light light = results.visibleLights[lightIndex].light;
        for (int i = 0; i < cascades; i++)
        {
            if (!results.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                lightIndex, i, cascades, shadows.mainLightShadowCascadesSplit, resolution, light.shadowNearPlane, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData split))
            {
                return false;
            }

            split.shadowCascadeBlendCullingFactor = 1f;
            data.Slices[i] = new ShadowSlice(view, projection, split, i % 2 * resolution, i / 2 * resolution, resolution);
        }

        return true;
    }

    /// <summary>The largest squares of which the atlas holds as many as there are cascades.</summary>
    private static int TileResolution(int width, int height, int count)
    {
        int resolution = Math.Min(width, height);
        while (width / resolution * (height / resolution) < count)
        {
            resolution >>= 1;
        }

        return resolution;
    }

    private static void Draw(RasterCommandBuffer cmd, Data data)
    {
        cmd.SetGlobalVector(WorldSpaceCameraPos, data.Camera.worldSpaceCameraPos);
        for (int i = 0; i < data.Slices.Length; i++)
        {
            ShadowSlice.SetCaster(cmd, data.Light, data.Slices[i].Bias(data.Light, data.Bias, data.Shadows.supportsSoftShadows));
            cmd.SetKeyword(RenderingKeywords.CastingPunctualLight, false);
            data.Slices[i].Draw(cmd, data.Casters[i]);
        }

        bool isSoft = data.Light.light.shadows == LightShadows.Soft && data.Shadows.supportsSoftShadows;
        cmd.SetKeyword(RenderingKeywords.MainLightShadows, data.Slices.Length == 1);
        cmd.SetKeyword(RenderingKeywords.MainLightShadowCascades, data.Slices.Length > 1);
        cmd.SetKeyword(RenderingKeywords.SoftShadows, isSoft);
        SetReceiver(cmd, data, isSoft);
    }

    private static void SetReceiver(RasterCommandBuffer cmd, Data data, bool isSoft)
    {
        // Behind the last cascade: nowhere, at the depth of what is lit.
        var nowhere = Matrix4x4.zero;
        nowhere.m22 = SystemInfo.usesReversedZBuffer ? 1f : 0f;
        var matrices = new Matrix4x4[MaxCascades + 1];
        var spheres = new Vector4[MaxCascades];
        Array.Fill(matrices, nowhere);
        for (int i = 0; i < data.Slices.Length; i++)
        {
            (matrices[i], spheres[i]) = (data.Slices[i].WorldToAtlas(data.Width, data.Height), data.Slices[i].Split.cullingSphere);
        }

        float distance = data.Camera.maxShadowDistance;
        (float scale, float bias) = ShadowSlice.Fade(distance * distance, data.Shadows.mainLightShadowCascadeBorder);
        cmd.SetGlobalMatrixArray(WorldToShadow, matrices);
        cmd.SetGlobalVector(Params, new Vector4(data.Light.light.shadowStrength, ShadowSlice.Softness(data.Light.light, isSoft), scale, bias));
        if (data.Slices.Length > 1)
        {
            for (int i = 0; i < MaxCascades; i++)
            {
                cmd.SetGlobalVector(Spheres[i], spheres[i]);
            }

            cmd.SetGlobalVector(Radii, new Vector4(Square(spheres[0].w), Square(spheres[1].w), Square(spheres[2].w), Square(spheres[3].w)));
        }

        if (data.Shadows.supportsSoftShadows)
        {
            (float x, float y) = (1f / data.Width, 1f / data.Height);
            cmd.SetGlobalVector(Offset0, new Vector4(-x, -y, x, -y) * 0.5f);
            cmd.SetGlobalVector(Offset1, new Vector4(-x, y, x, y) * 0.5f);
            cmd.SetGlobalVector(Size, new Vector4(x, y, data.Width, data.Height));
        }
    }

    /// <summary>A lit texel under the name of the map; matrices and spheres stay as another camera left them.</summary>
    private static void RecordEmpty(RenderGraph graph, ContextContainer frame, Light? light)
    {
        UniversalShadowData shadows = frame.Get<UniversalShadowData>();
        using IRasterRenderGraphBuilder builder = graph.AddRasterRenderPass("Empty Main Light Shadowmap", out EmptyData data);
        (float scale, float bias) = light is null ? (1f, 0f) : ShadowSlice.Fade(frame.Get<UniversalCameraData>().maxShadowDistance, shadows.mainLightShadowCascadeBorder);
        data.Params = new Vector4(light?.shadowStrength ?? 0f, 0f, scale, bias);
        TextureHandle map = graph.CreateTexture(new TextureDesc(1, 1)
        {
            format = GraphicsFormat.D32_SFloat,
            isShadowMap = true,
            clearBuffer = true,
            name = "_DefaultShadowTexture",
        });
        builder.SetRenderAttachmentDepth(map);
        builder.SetGlobalTextureAfterPass(map, Map);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (EmptyData d, RasterGraphContext context) =>
        {
            context.cmd.SetKeyword(RenderingKeywords.MainLightShadows, true);
            context.cmd.SetGlobalVector(Size, Vector4.one);
            context.cmd.SetGlobalVector(Params, d.Params);
        });
    }

    private static float Square(float value) => value * value;

    private sealed class Data
    {
        public UniversalCameraData Camera { get; init; } = null!;
        public UniversalShadowData Shadows { get; init; } = null!;
        public VisibleLight Light { get; set; }
        public Vector4 Bias { get; set; }
        public ShadowSlice[] Slices { get; set; } = [];
        public RendererListHandle[] Casters { get; set; } = [];
        public int Width { get; set; }
        public int Height { get; set; }
    }

    private sealed class Holder
    {
        public Data Data { get; set; } = null!;
    }

    private sealed class EmptyData
    {
        public Vector4 Params { get; set; }
    }
}
