using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Frames that are drawn by a pipeline of the test.</summary>
public abstract class ScriptableFixture : SceneFixture
{
    protected static readonly ShaderTagId Unlit = new("SRPDefaultUnlit");

    // A colour a pass: the first is untagged.
    protected const string TwoPasses = """
        Shader "Test/TwoPasses"
        {
            Properties { _Color ("Color", Color) = (1, 1, 1, 1) }
            SubShader
            {
                HLSLINCLUDE
                #include "UnityCG.cginc"
                float4 _Color;
                float4 Vertex(float4 position : POSITION) : SV_POSITION { return UnityObjectToClipPos(position); }
                float4 Red() : SV_Target { return float4(1, 0, 0, 1); }
                float4 Green() : SV_Target { return float4(0, 1, 0, 1); }
                ENDHLSL
                Pass
                {
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Red
                    ENDHLSL
                }
                Pass
                {
                    Tags { "LightMode" = "Second" }
                    ZTest Always
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Green
                    ENDHLSL
                }
            }
        }
        """;

    [TearDown]
    public void BackToBuiltin()
    {
        GraphicsSettings.defaultRenderPipeline = null;
        QualitySettings.renderPipeline = null;
        (GraphicsSettings.lightsUseLinearIntensity, GraphicsSettings.lightsUseColorTemperature) = (false, false);
        QualitySettings.shadowDistance = 150f;
    }

    protected static TestPipelineAsset Use(Action<ScriptableRenderContext, Camera[]> render)
    {
        var asset = ScriptableObject.CreateInstance<TestPipelineAsset>();
        asset.Make = () => new TestPipeline(render);
        GraphicsSettings.defaultRenderPipeline = asset;
        return asset;
    }

    /// <summary>One that draws the first camera after clearing to black.</summary>
    protected static void UseOne(Action<ScriptableRenderContext, Camera, CullingResults> draw) => Use((context, cameras) =>
    {
        context.SetupCameraProperties(cameras[0]);
        Run(context, c => c.ClearRenderTarget(true, true, Color.black));
        draw(context, cameras[0], Cull(context, cameras[0]));
        context.Submit();
    });

    protected static CullingResults Cull(ScriptableRenderContext context, Camera camera)
    {
        Assert.That(camera.TryGetCullingParameters(out ScriptableCullingParameters parameters), Is.True);
        return context.Cull(ref parameters);
    }

    protected static void Run(ScriptableRenderContext context, Action<CommandBuffer> record)
    {
        using var commands = new CommandBuffer();
        record(commands);
        context.ExecuteCommandBuffer(commands);
    }

    protected static DrawingSettings Drawing(Camera camera, params ShaderTagId[] passes) => Drawing(camera, SortingCriteria.CommonOpaque, passes);

    protected static DrawingSettings Drawing(Camera camera, SortingCriteria order, params ShaderTagId[] passes)
    {
        var drawing = new DrawingSettings(passes[0], new SortingSettings(camera) { criteria = order });
        for (int i = 1; i < passes.Length; i++)
        {
            drawing.SetShaderPassName(i, passes[i]);
        }

        return drawing;
    }

    protected static RendererList List(ScriptableRenderContext context, CullingResults culled, DrawingSettings drawing, FilteringSettings? filtering = null)
    {
        var parameters = new RendererListParams(culled, drawing, filtering ?? FilteringSettings.defaultValue);
        return context.CreateRendererList(ref parameters);
    }

    protected static void Draw(ScriptableRenderContext context, RendererList list) => Run(context, c => c.DrawRendererList(list));

    protected static Color32 Middle() => Picture.OfScreen().At(64, 48);
}
