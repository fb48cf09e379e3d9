using System.Text;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.RenderGraphModule;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>Writes what a shader sees at an event into a row of pixels, one for each expression.</summary>
internal sealed class FactProbe : ScriptableRenderPass
{
    private readonly Material material;
    private readonly RenderTexture row;
    private readonly int count;

    public FactProbe(RenderPassEvent at, ScriptableRenderPassInput inputs, Func<string, Material> compile, string declarations, IReadOnlyList<string> expressions)
    {
        renderPassEvent = at;
        ConfigureInput(inputs);
        count = expressions.Count;
        material = compile(Source(declarations, expressions));
        row = new RenderTexture(new RenderTextureDescriptor(count, 1, GraphicsFormat.R32G32B32A32_SFloat, 0)) { name = $"Facts at {at}" };
    }

    public override void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData)
    {
        using IUnsafeRenderGraphBuilder builder = renderGraph.AddUnsafePass($"Facts at {renderPassEvent}", out Data data);
        (data.Row, data.Material) = (row, material);
        builder.AllowPassCulling(false);
        builder.UseAllGlobalTextures(true);
        builder.SetRenderFunc(static (Data d, UnsafeGraphContext context) =>
        {
            context.cmd.SetRenderTarget(d.Row);
            context.cmd.DrawProcedural(Matrix4x4.identity, d.Material, 0, MeshTopology.Triangles, 3);
        });
    }

    public Vector4[] Read()
    {
        RenderTexture? active = RenderTexture.active;
        RenderTexture.active = row;
        var copy = new Texture2D(count, 1, TextureFormat.RGBAFloat, false);
        copy.ReadPixels(new Rect(0, 0, count, 1), 0, 0, false);
        RenderTexture.active = active;
        return [.. copy.GetPixels().Select(c => (Vector4)c)];
    }

    private static string Source(string declarations, IReadOnlyList<string> expressions)
    {
        var cases = new StringBuilder();
        for (int i = 0; i < expressions.Count; i++)
        {
            cases.Append($"case {i}: value = {expressions[i]}; break;\n");
        }

        return $$"""
            Shader "Test/Facts"
            {
                SubShader
                {
                    Pass
                    {
                        ZTest Always
                        ZWrite Off
                        Cull Off
                        HLSLPROGRAM
                        #pragma target 4.5
                        #pragma vertex Cover
                        #pragma fragment Tell
                        #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
                        #pragma multi_compile _ _SHADOWS_SOFT
                        #pragma multi_compile _ _ADDITIONAL_LIGHTS
                        #pragma multi_compile _ _FORWARD_PLUS
                        #pragma multi_compile _ _CLUSTER_LIGHT_LOOP
                        {{declarations}}
                        float4 Cover(uint index : SV_VertexID) : SV_Position
                        {
                            return float4(float2((index << 1) & 2, index & 2) * 2.0 - 1.0, 0.5, 1.0);
                        }
                        float4 Tell(float4 position : SV_Position) : SV_Target
                        {
                            float4 value = 0.0;
                            switch ((int)position.x)
                            {
                                {{cases}}
                            }
                            return value;
                        }
                        ENDHLSL
                    }
                }
            }
            """;
    }

    private sealed class Data
    {
        public RenderTargetIdentifier Row { get; set; }
        public Material Material { get; set; } = null!;

        public Data()
        {
        }
    }
}
