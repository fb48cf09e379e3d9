using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class ProceduralTests : SceneFixture
{
    private const string Points = """
        Shader "Test/Points"
        {
            SubShader
            {
                Pass
                {
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma target 4.5
                    #include "UnityCG.cginc"
                    StructuredBuffer<float3> _Positions;
                    float _Size;
                    float4 Vertex(uint id : SV_VertexID) : SV_POSITION
                    {
                        uint corner = id % 6;
                        float2 offset = float2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5) - 0.5;
                        return mul(unity_MatrixVP, float4(_Positions[id / 6] + float3(offset * _Size, 0), 1));
                    }
                    float4 Fragment() : SV_Target { return float4(1, 0, 0, 1); }
                    ENDHLSL
                }
                Pass
                {
                    Tags { "LightMode" = "UniversalForward" }
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    float4 Vertex(uint id : SV_VertexID) : SV_POSITION { return float4(id == 1 ? 3 : -1, id == 2 ? 3 : -1, 0.5, 1); }
                    float4 Fragment() : SV_Target { return float4(0, 1, 0, 1); }
                    ENDHLSL
                }
            }
        }
        """;

    private const string GeometryPoints = """
        Shader "Test/Geometry"
        {
            SubShader
            {
                Pass
                {
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma geometry Geometry
                    #pragma fragment Fragment
                    #pragma target 5.0
                    #include "UnityCG.cginc"
                    StructuredBuffer<float3> _Positions;
                    float _Size;
                    struct Input { float3 world : TEXCOORD0; };
                    struct Output { float4 position : SV_POSITION; };
                    Input Vertex(uint id : SV_VertexID)
                    {
                        Input o;
                        o.world = _Positions[id];
                        return o;
                    }
                    [maxvertexcount(4)]
                    void Geometry(point Input input[1], inout TriangleStream<Output> stream)
                    {
                        for (uint i = 0; i < 4; i++)
                        {
                            Output o;
                            o.position = mul(unity_MatrixVP, float4(input[0].world + float3((float2(i & 1, i >> 1) - 0.5) * _Size, 0), 1));
                            stream.Append(o);
                        }
                    }
                    float4 Fragment(Output i) : SV_Target { return float4(1, 0, 0, 1); }
                    ENDHLSL
                }
            }
        }
        """;

    private static readonly Vector3[] Positions = [new(-1f, 0f, 0f), new(1f, 0f, 0f), new(0f, 1f, 0f)];

    private GraphicsBuffer positions = null!;

    [SetUp]
    public void MakePositions()
    {
        positions = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 12);
        positions.SetData(Positions);
    }

    [TearDown]
    public void FreePositions() => positions.Dispose();

    [Test]
    public void IndirectPrimitivesTakeCountsFromTheGpu()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        using var arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments, 1, GraphicsBuffer.IndirectDrawArgs.size);
        RenderParams draw = Params(Points);
        foreach ((uint vertices, int squares) in ((uint, int)[])[(18, 3), (12, 2), (0, 0)])
        {
            arguments.SetData(new[] { new GraphicsBuffer.IndirectDrawArgs { vertexCountPerInstance = vertices, instanceCount = 1 } });
            Graphics.RenderPrimitivesIndirect(draw, MeshTopology.Triangles, arguments);
            Frame();
            AssertSquares(camera, Picture.OfScreen(), squares);
        }
    }

    [Test]
    public void GeometryShadersEmitSquares()
    {
        Assume.That(SystemInfo.supportsGeometryShaders);
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Graphics.RenderPrimitives(Params(GeometryPoints), MeshTopology.Points, 3);
        Frame();
        AssertSquares(camera, Picture.OfScreen().Keep("geometry"), 3);
    }

    [Test]
    public void CommandBuffersDrawAtCameraEvents()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Material material = MaterialOf(Points);
        var block = new MaterialPropertyBlock();
        block.SetBuffer("_Positions", positions);
        block.SetFloat("_Size", 0.5f);
        using var commands = new CommandBuffer();
        commands.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 18, 1, block);

        // What the block holds later does not matter.
        block.SetFloat("_Size", 50f);
        camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, commands);
        Frame();
        AssertSquares(camera, Picture.OfScreen(), 3);
        camera.RemoveCommandBuffer(CameraEvent.AfterForwardOpaque, commands);
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);
    }

    [Test]
    public void CommandBuffersDrawIntoTexturesWithTheirOwnMatrices()
    {
        Material material = MaterialOf(Points);
        material.SetBuffer("_Positions", positions);
        material.SetFloat("_Size", 0.5f);
        var target = new RenderTexture(64, 64, 24);
        using var commands = new CommandBuffer();
        commands.SetRenderTarget(target);
        commands.ClearRenderTarget(true, true, Color.green);
        commands.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.Ortho(-2f, 2f, -2f, 2f, -1f, 1f));
        commands.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 18);
        Graphics.ExecuteCommandBuffer(commands);
        Picture picture = Picture.Of(target);
        Assert.That(IsRed(picture.At(16, 32)), Is.True);
        Assert.That(IsRed(picture.At(32, 48)), Is.True, "the third square is above the middle");
        Assert.That(IsGreen(picture.At(32, 16)), Is.True);
    }

    [Test]
    public void QueuedDrawsThrowShadows()
    {
        Camera camera = Camera(new Vector3(0f, 4f, -4f), Vector3.zero);
        Sun(Vector3.down);
        Primitive(PrimitiveType.Plane, Vector3.zero);

        // One square of two metres, lying flat a metre above the plane, that only the light sees.
        RenderParams draw = Params(Points
            .Replace("float3(offset * _Size, 0)", "float3(offset.x * _Size, 1, offset.y * _Size)")
            .Replace("Cull Off", "Tags { \"LightMode\" = \"ShadowCaster\" } Cull Off"));
        draw.matProps!.SetFloat("_Size", 2f);
        draw.shadowCastingMode = ShadowCastingMode.On;
        positions.SetData(new[] { Vector3.zero, Vector3.zero, Vector3.zero });
        Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 6);
        Frame();
        Picture picture = Picture.OfScreen().Keep("procedural-shadow");
        Assert.That(
            picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.5f, 0f, 0.5f))) * 1.4f,
            Is.LessThan(picture.Brightness(camera.WorldToScreenPoint(new Vector3(1.6f, 0f, 0f)))));
        Frame();
        picture = Picture.OfScreen();
        Assert.That(picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.5f, 0f, 0.5f))), Is.GreaterThan(0.5f), "the draw lasted one frame");
    }

    [Test]
    public void DispatchesAndDrawsMixAtACameraEvent()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, new Vector3(0f, -1.5f, 0f), Color.green);
        ComputeShader mover = Compute("""
            #pragma kernel Main
            RWStructuredBuffer<float3> _Moved;
            float _Height;
            [numthreads(1, 1, 1)]
            void Main(uint3 id : SV_DispatchThreadID) { _Moved[id.x].y = _Height; }
            """);
        Material material = MaterialOf(Points);
        material.SetBuffer("_Positions", positions);
        material.SetFloat("_Size", 0.4f);
        using var commands = new CommandBuffer();
        foreach (float height in (float[])[0.5f, -0.5f])
        {
            commands.SetComputeFloatParam(mover, "_Height", height);
            commands.SetComputeBufferParam(mover, 0, "_Moved", positions);
            commands.DispatchCompute(mover, 0, 2, 1, 1);
            commands.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 12);
        }

        camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, commands);
        Frame();
        Picture picture = Picture.OfScreen();
        foreach (float x in (float[])[-1f, 1f])
        {
            Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(new Vector3(x, 0.5f, 0f)))), Is.True);
            Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(new Vector3(x, -0.5f, 0f)))), Is.True);
        }

        Assert.That(IsGreen(picture.At(camera.WorldToScreenPoint(new Vector3(0f, -1.5f, -0.5f)))), Is.True, "what was drawn before is kept");
    }

    [Test]
    public void QuadsAndIndicesWithoutAMesh()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        using var indices = new GraphicsBuffer(GraphicsBuffer.Target.Index, 6, sizeof(uint));
        indices.SetData(new uint[] { 6, 7, 8, 9, 10, 11 });
        Graphics.RenderPrimitivesIndexed(Params(Points), MeshTopology.Triangles, indices, 6);
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Positions[1]))), Is.True);
        Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Positions[0]))), Is.False);
        string quads = Points.Replace("id % 6", "id % 4").Replace("id / 6", "id / 4")
            .Replace("corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5", "corner == 1 || corner == 2, corner >= 2");
        Graphics.RenderPrimitives(Params(quads), MeshTopology.Quads, 12);
        Frame();
        AssertSquares(camera, Picture.OfScreen(), 3);
    }

    [Test]
    public void AMissingBufferSkipsTheDrawAndIsNamed()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        var draw = new RenderParams(MaterialOf(Points)) { worldBounds = new Bounds(Vector3.zero, Vector3.one * 10f) };
        Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 18);
        Frame();
        Assert.That(TakeErrors(), Has.Some.Contains("_Positions"));
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);
    }

    [Test]
    public void DrawsOutsideTheViewAreCulledAndLastOneFrame()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        RenderParams draw = Params(Points);
        Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 18);
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.GreaterThan(0f));
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);
        draw.worldBounds = new Bounds(new Vector3(0f, 0f, -50f), Vector3.one);
        Graphics.RenderPrimitives(draw, MeshTopology.Triangles, 18);
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);
    }

    private RenderParams Params(string shader)
    {
        var block = new MaterialPropertyBlock();
        block.SetBuffer("_Positions", positions);
        block.SetFloat("_Size", 0.5f);
        return new RenderParams(MaterialOf(shader)) { worldBounds = new Bounds(Vector3.zero, Vector3.one * 10f), matProps = block };
    }

    private static void AssertSquares(Camera camera, Picture picture, int count)
    {
        for (int i = 0; i < Positions.Length; i++)
        {
            Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Positions[i]))), Is.EqualTo(i < count), $"square {i} of {count}");
        }

        Assert.That(picture.Share(IsGreen), Is.Zero, "passes of other pipelines are not drawn");
    }
}
