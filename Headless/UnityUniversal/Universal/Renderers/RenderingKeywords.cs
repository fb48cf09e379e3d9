using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The keywords that each camera begins without, and those that transparents go by.</summary>
internal static class RenderingKeywords
{
    public static readonly GlobalKeyword MainLightShadows = GlobalKeyword.Create("_MAIN_LIGHT_SHADOWS");
    public static readonly GlobalKeyword MainLightShadowCascades = GlobalKeyword.Create("_MAIN_LIGHT_SHADOWS_CASCADE");
    public static readonly GlobalKeyword AdditionalLightsVertex = GlobalKeyword.Create("_ADDITIONAL_LIGHTS_VERTEX");
    public static readonly GlobalKeyword AdditionalLightsPixel = GlobalKeyword.Create("_ADDITIONAL_LIGHTS");
    public static readonly GlobalKeyword AdditionalLightShadows = GlobalKeyword.Create("_ADDITIONAL_LIGHT_SHADOWS");
    public static readonly GlobalKeyword SoftShadows = GlobalKeyword.Create("_SHADOWS_SOFT");
    public static readonly GlobalKeyword CastingPunctualLight = GlobalKeyword.Create("_CASTING_PUNCTUAL_LIGHT_SHADOW");
    public static readonly GlobalKeyword ForwardPlus = GlobalKeyword.Create("_FORWARD_PLUS");
    public static readonly GlobalKeyword ClusterLightLoop = GlobalKeyword.Create("_CLUSTER_LIGHT_LOOP");
    public static readonly GlobalKeyword ReflectionProbeBlending = GlobalKeyword.Create("_REFLECTION_PROBE_BLENDING");
    public static readonly GlobalKeyword ReflectionProbeBoxProjection = GlobalKeyword.Create("_REFLECTION_PROBE_BOX_PROJECTION");
    public static readonly GlobalKeyword LightLayers = GlobalKeyword.Create("_LIGHT_LAYERS");

    private static readonly GlobalKeyword[] All =
    [
        MainLightShadows, MainLightShadowCascades, AdditionalLightsVertex, AdditionalLightsPixel, AdditionalLightShadows, SoftShadows, ForwardPlus,
        ClusterLightLoop, ReflectionProbeBlending, ReflectionProbeBoxProjection, LightLayers,
    ];

    public static void RecordReset(RenderGraph graph)
    {
        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("Clear Rendering State", out Data _);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data _, UnsafeGraphContext context) =>
        {
            foreach (GlobalKeyword keyword in All)
            {
                context.cmd.SetKeyword(keyword, false);
            }
        });
    }

    /// <summary>A renderer may keep transparents out of the shadows.</summary>
    public static void RecordTransparent(RenderGraph graph, bool receive)
    {
        if (receive)
        {
            return;
        }

        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("Transparent Settings", out Data _);
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data _, UnsafeGraphContext context) =>
        {
            context.cmd.SetKeyword(MainLightShadows, false);
            context.cmd.SetKeyword(MainLightShadowCascades, false);
            context.cmd.SetKeyword(AdditionalLightShadows, false);
        });
    }

    private sealed class Data;
}
