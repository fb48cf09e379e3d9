using NUnit.Framework;
using Headless.Shaders;

namespace Headless.Tests.Vulkan;

/// <summary>The shaders that the drawing tests share.</summary>
internal static class DrawShaders
{
    /// <summary>A clockwise triangle over the upper left half of the target at depth _Depth: corners (-1, 1), (1, 1), (-1, -1).</summary>
    public static ShaderBinary CornerTriangle { get; } = TestShader.Vertex("CornerTriangle", """
        [[vk::binding(0, 0)]] cbuffer Constants { float _Depth; };
        float4 CornerTriangle(uint id : SV_VertexID) : SV_Position
        {
            float x = id == 1 ? 1.0 : -1.0;
            float y = id == 2 ? -1.0 : 1.0;
            return float4(x, y, _Depth, 1);
        }
        """, [], TestShader.Uniform(0, 16));

    /// <summary>A clockwise triangle that covers the whole target at depth 0.5.</summary>
    public static ShaderBinary FullScreen { get; } = TestShader.Vertex("FullScreen", """
        struct Output { float4 position : SV_Position; float2 uv : TEXCOORD0; };
        Output FullScreen(uint id : SV_VertexID)
        {
            Output output;
            output.uv = float2(id == 1 ? 2 : 0, id == 2 ? 2 : 0);
            output.position = float4(output.uv.x * 2 - 1, 1 - output.uv.y * 2, 0.5, 1);
            return output;
        }
        """, []);

    /// <summary>Position from a vertex buffer.</summary>
    public static ShaderBinary MeshVertex { get; } = TestShader.Vertex("MeshVertex", """
        float4 MeshVertex(float2 position : POSITION) : SV_Position { return float4(position, 0.5, 1); }
        """, [new VertexInput("POSITION", 0, 2, false)]);

    /// <summary>Points from a buffer, for the geometry stage.</summary>
    public static ShaderBinary PointVertex { get; } = TestShader.Vertex("PointVertex", """
        [[vk::binding(0, 0)]] StructuredBuffer<float2> _Centers;
        float4 PointVertex(uint id : SV_VertexID) : SV_Position { return float4(_Centers[id], 0.5, 1); }
        """, [], TestShader.Read(0, "_Centers"));

    /// <summary>A square of side 2 * _Half around each point.</summary>
    public static ShaderBinary Squares { get; } = TestShader.Stage(ShaderStage.Geometry, "Squares", """
        [[vk::binding(0, 1)]] cbuffer Constants { float _Half; };
        struct Corner { float4 position : SV_Position; };
        [maxvertexcount(4)] void Squares(point float4 center[1] : SV_Position, inout TriangleStream<Corner> stream)
        {
            for (int i = 0; i < 4; i++)
            {
                Corner corner;
                corner.position = center[0] + float4((i & 1) == 0 ? -_Half : _Half, i < 2 ? _Half : -_Half, 0, 0);
                stream.Append(corner);
            }
        }
        """, TestShader.Uniform(0, 16));

    /// <summary>One color.</summary>
    public static ShaderBinary Plain { get; } = TestShader.Stage(ShaderStage.Fragment, "Plain", """
        [[vk::binding(0, 2)]] cbuffer Constants { float4 _Color; };
        float4 Plain() : SV_Target { return _Color; }
        """, TestShader.Uniform(0, 16));

    /// <summary>A texture through a sampler.</summary>
    public static ShaderBinary Textured { get; } = TestShader.Stage(ShaderStage.Fragment, "Textured", """
        [[vk::binding(0, 2)]] Texture2D<float4> _Image;
        [[vk::binding(1, 2)]] SamplerState sampler_Image;
        float4 Textured(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target { return _Image.Sample(sampler_Image, uv); }
        """, TestShader.Texture(0, "_Image"), TestShader.Sampler(1, "sampler_Image"));

    /// <summary>1 where _Depth's texel is greater than or equal to 0.5, by comparison.</summary>
    public static ShaderBinary Shadow { get; } = TestShader.Stage(ShaderStage.Fragment, "Shadow", """
        [[vk::binding(0, 2)]] Texture2D<float> _Map;
        [[vk::binding(1, 2)]] SamplerComparisonState sampler_Map;
        float4 Shadow(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target { return _Map.SampleCmpLevelZero(sampler_Map, uv, 0.5).xxxx; }
        """, TestShader.Texture(0, "_Map"), TestShader.Sampler(1, "sampler_Map"));
}
