using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>Draws whose vertices, indices and counts are made by kernels.</summary>
public sealed class IndirectTests : SceneFixture
{
    // Squares of two triangles over four shared corners; the kernel writes one square a thread.
    private const string Squares = """
        Shader "Test/Squares"
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
                    struct Corner { float3 position; float3 color; };
                    StructuredBuffer<Corner> _Corners;
                    struct Varyings { float4 position : SV_POSITION; float3 color : TEXCOORD0; };
                    Varyings Vertex(uint id : SV_VertexID)
                    {
                        Varyings o;
                        o.position = UnityWorldToClipPos(_Corners[id].position);
                        o.color = _Corners[id].color;
                        return o;
                    }
                    float4 Fragment(Varyings i) : SV_Target { return float4(i.color, 1); }
                    ENDHLSL
                }
                Pass
                {
                    Tags { "LightMode" = "ShadowCaster" }
                    Cull Off
                    HLSLPROGRAM
                    #pragma vertex Vertex
                    #pragma fragment Fragment
                    #pragma target 4.5
                    #include "UnityCG.cginc"
                    struct Corner { float3 position; float3 color; };
                    StructuredBuffer<Corner> _Corners;
                    float4 Vertex(uint id : SV_VertexID) : SV_POSITION { return UnityApplyLinearShadowBias(UnityWorldToClipPos(_Corners[id].position)); }
                    float4 Fragment() : SV_Target { return 0; }
                    ENDHLSL
                }
            }
        }
        """;

    private const string Mesher = """
        #pragma kernel Count
        #pragma kernel Emit
        struct Corner { float3 position; float3 color; };
        RWStructuredBuffer<Corner> _Corners;
        RWByteAddressBuffer _Indices;
        RWStructuredBuffer<uint> _Draw;
        RWStructuredBuffer<uint> _Groups;
        uint _Squares;
        float3 _Step;
        float3 _Right;
        float3 _Up;
        [numthreads(1, 1, 1)]
        void Count()
        {
            _Groups[0] = _Squares; _Groups[1] = 1; _Groups[2] = 1;
            _Draw[0] = _Squares * 6; _Draw[1] = 1; _Draw[2] = 0; _Draw[3] = 0; _Draw[4] = 0;
        }
        [numthreads(1, 1, 1)]
        void Emit(uint3 id : SV_GroupID)
        {
            const uint Order[6] = { 0, 2, 1, 1, 2, 3 };
            for (uint c = 0; c < 4; c++)
            {
                _Corners[id.x * 4 + c].position = _Step * id.x + _Right * ((c & 1) - 0.5) + _Up * ((c >> 1) - 0.5);
                _Corners[id.x * 4 + c].color = float3(1, 0, 0);
            }
            for (uint i = 0; i < 6; i++) { _Indices.Store((id.x * 6 + i) * 4, id.x * 4 + Order[i]); }
        }
        """;

    private const int Capacity = 8;
    private GraphicsBuffer corners = null!;
    private GraphicsBuffer indices = null!;
    private GraphicsBuffer draw = null!;
    private GraphicsBuffer groups = null!;
    private ComputeShader mesher = null!;

    [SetUp]
    public void MakeBuffers()
    {
        corners = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Capacity * 4, 24);
        indices = new GraphicsBuffer(GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.Index, Capacity * 6, sizeof(uint));
        draw = new GraphicsBuffer(GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.IndirectArguments, 5, sizeof(uint));
        groups = new GraphicsBuffer(GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.IndirectArguments, 3, sizeof(uint));
        mesher = Compute(Mesher, "Mesher");
    }

    [TearDown]
    public void FreeBuffers()
    {
        foreach (GraphicsBuffer buffer in (GraphicsBuffer[])[corners, indices, draw, groups])
        {
            buffer.Dispose();
        }
    }

    [Test]
    public void OneIndexedDrawIsSeenByEveryCamera()
    {
        Camera left = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        left.rect = new Rect(0f, 0f, 0.5f, 1f);
        Camera right = Camera(new Vector3(0f, 0f, 5f), Vector3.zero);
        right.rect = new Rect(0.5f, 0f, 0.5f, 1f);
        foreach (uint count in (uint[])[1, 2, 0])
        {
            Mesh(count, Vector3.right * 1.5f, Vector3.right, Vector3.up);
            Graphics.RenderPrimitivesIndexedIndirect(Params(), MeshTopology.Triangles, indices, draw);
            Frame();
            Picture picture = Picture.OfScreen();
            foreach (Camera camera in (Camera[])[left, right])
            {
                Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Vector3.zero))), Is.EqualTo(count > 0), $"first of {count}");
                Assert.That(IsRed(picture.At(camera.WorldToScreenPoint(Vector3.right * 1.5f))), Is.EqualTo(count > 1), $"second of {count}");
            }
        }
    }

    [Test]
    public void AnIndexedDrawThrowsShadows()
    {
        Camera camera = Camera(new Vector3(0f, 4f, -4f), Vector3.zero);
        Sun(Vector3.down);
        Primitive(PrimitiveType.Plane, Vector3.zero);
        Mesh(1, Vector3.up, Vector3.right * 2f, Vector3.forward * 2f);
        RenderParams parameters = Params();
        parameters.shadowCastingMode = ShadowCastingMode.ShadowsOnly;

        // The square lies in the plane itself: raise it.
        var raised = new Vector3[Capacity * 8];
        corners.GetData(raised);
        for (int i = 0; i < 4; i++)
        {
            raised[i * 2] += Vector3.up;
        }

        corners.SetData(raised);
        Graphics.RenderPrimitivesIndexedIndirect(parameters, MeshTopology.Triangles, indices, draw);
        Frame();
        Picture picture = Picture.OfScreen().Keep("indexed-shadow");
        float shadow = picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.5f, 0f, 0.5f)));
        float lit = picture.Brightness(camera.WorldToScreenPoint(new Vector3(1.6f, 0f, 0f)));
        Assert.That(shadow * 1.4f, Is.LessThan(lit));
        Assert.That(picture.Share(IsRed), Is.Zero, "only its shadow is drawn");
    }

    [Test]
    public void CommandBuffersDrawWithIndicesAndCountsFromTheGpu([Values] bool withBlock)
    {
        Material material = MaterialOf(Squares);
        MaterialPropertyBlock? block = null;
        if (withBlock)
        {
            block = new MaterialPropertyBlock();
            block.SetBuffer("_Corners", corners);
        }
        else
        {
            material.SetBuffer("_Corners", corners);
        }

        var target = new RenderTexture(64, 64, 24);
        using var commands = new CommandBuffer();
        Record(commands, 2, new Vector3(0f, 1f, 0f), Vector3.right, Vector3.up);
        commands.SetRenderTarget(target);
        commands.ClearRenderTarget(true, true, Color.green);
        commands.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.Ortho(-2f, 2f, -2f, 2f, -1f, 1f));
        if (withBlock)
        {
            commands.DrawProceduralIndirect(indices, Matrix4x4.identity, material, 0, MeshTopology.Triangles, draw, 0, block);
        }
        else
        {
            commands.DrawProceduralIndirect(indices, Matrix4x4.identity, material, 0, MeshTopology.Triangles, draw, 0);
        }

        Graphics.ExecuteCommandBuffer(commands);
        Picture picture = Picture.Of(target);
        Assert.That(picture.Share(IsRed), Is.EqualTo(2f / 16f).Within(1e-3f), "two of sixteen square metres");
        Assert.That(IsRed(picture.At(32, 32)) && IsRed(picture.At(32, 48)), Is.True);
        Assert.That(IsGreen(picture.At(32, 16)), Is.True, "the second square is above the first");
    }

    private RenderParams Params()
    {
        var block = new MaterialPropertyBlock();
        block.SetBuffer("_Corners", corners);
        return new RenderParams(MaterialOf(Squares)) { worldBounds = new Bounds(Vector3.zero, Vector3.one * 10f), matProps = block };
    }

    private void Mesh(uint squares, Vector3 step, Vector3 right, Vector3 up)
    {
        using var commands = new CommandBuffer();
        Record(commands, squares, step, right, up);
        Graphics.ExecuteCommandBuffer(commands);
    }

    private void Record(CommandBuffer commands, uint squares, Vector3 step, Vector3 right, Vector3 up)
    {
        int count = mesher.FindKernel("Count");
        int emit = mesher.FindKernel("Emit");
        commands.SetComputeIntParam(mesher, "_Squares", (int)squares);
        commands.SetComputeVectorParam(mesher, "_Step", step);
        commands.SetComputeVectorParam(mesher, "_Right", right);
        commands.SetComputeVectorParam(mesher, "_Up", up);
        commands.SetComputeBufferParam(mesher, count, "_Draw", draw);
        commands.SetComputeBufferParam(mesher, count, "_Groups", groups);
        commands.DispatchCompute(mesher, count, 1, 1, 1);
        commands.SetComputeBufferParam(mesher, emit, "_Corners", corners);
        commands.SetComputeBufferParam(mesher, emit, "_Indices", indices);
        commands.DispatchCompute(mesher, emit, groups, 0);
    }
}
