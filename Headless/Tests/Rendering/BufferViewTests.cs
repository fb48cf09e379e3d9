using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>What a shader declares against what the bound buffer was created as: Direct3D 11 gives one view only.</summary>
public sealed class BufferViewTests : SceneFixture
{
    private const GraphicsBuffer.Target Arguments = GraphicsBuffer.Target.IndirectArguments;

    private static readonly string[] None = [];

    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Structured)]
    [TestCase("StructuredBuffer<uint> _B;", "_Out[0] = _B[0];", GraphicsBuffer.Target.Structured)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Raw)]
    [TestCase("ByteAddressBuffer _B;", "_Out[0] = _B.Load(0);", GraphicsBuffer.Target.Raw)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Raw | Arguments)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.Index)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.Vertex)]
    [TestCase("ByteAddressBuffer _B;", "_Out[0] = _B.Load(0);", Arguments)]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Structured | Arguments)]
    public void WhatItWasCreatedForFits(string declaration, string use, GraphicsBuffer.Target target) =>
        Assert.That(Dispatch(declaration, use, new GraphicsBuffer(target, 4, 4)), Is.EqualTo(None));

    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", Arguments, "IndirectArguments | Raw and declare RWByteAddressBuffer")]
    [TestCase("StructuredBuffer<uint> _B;", "_Out[0] = _B[0];", Arguments, "IndirectArguments | Raw and declare ByteAddressBuffer")]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", Arguments, "add Raw")]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Raw, "declare RWByteAddressBuffer")]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Raw | Arguments, "declare RWByteAddressBuffer")]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Structured, "create it as Raw instead")]
    [TestCase("ByteAddressBuffer _B;", "_Out[0] = _B.Load(0);", GraphicsBuffer.Target.Structured | Arguments, "create it as Raw instead")]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Index, "add Raw")]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", GraphicsBuffer.Target.Vertex, "add Raw")]
    [TestCase("StructuredBuffer<float2> _B;", "_Out[0] = _B[0].x;", GraphicsBuffer.Target.Structured, "8 in the shader, 4 in the buffer")]
    [TestCase("RWStructuredBuffer<float3> _B;", "_B[0] = 1;", GraphicsBuffer.Target.Structured, "12 in the shader, 4 in the buffer")]
    public void AnotherViewFailsTheDispatchAndSaysHowToMendIt(string declaration, string use, GraphicsBuffer.Target target, string cure)
    {
        string[] errors = Dispatch(declaration, use, new GraphicsBuffer(target, 4, 4) { name = "Numbers" });
        Assert.That(errors, Has.Length.EqualTo(1));
        Assert.That(errors[0], Does.Contain("kernel 'K'").And.Contain("'_B'").And.Contain("'Numbers'").And.Contain(target.ToString()).And.Contain(cure));
        Assert.That(errors[0], Does.Not.Contain("\n"));
    }

    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", ComputeBufferType.Default, true)]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", ComputeBufferType.Structured | ComputeBufferType.IndirectArguments, true)]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", ComputeBufferType.IndirectArguments, false)]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", ComputeBufferType.Raw, false)]
    [TestCase("RWStructuredBuffer<uint> _B;", "_B[0] = 1;", ComputeBufferType.Constant, false)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", ComputeBufferType.Raw, true)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", ComputeBufferType.Raw | ComputeBufferType.IndirectArguments, true)]
    [TestCase("RWByteAddressBuffer _B;", "_B.Store(0, 1);", ComputeBufferType.Default, false)]
    public void ComputeBuffersAreHeldToTheSameRule(string declaration, string use, ComputeBufferType type, bool fits)
    {
        using var buffer = new ComputeBuffer(4, 4, type);
        ComputeShader shader = Kernel(declaration, use);
        shader.SetBuffer(0, "_B", buffer);
        Assert.That(Run(shader), fits ? Is.Empty : Has.Length.EqualTo(1));
    }

    [Test]
    public void TheKindIsThatBehindTheShadersMacros()
    {
        const string declaration = """
            #define WORDS RWByteAddressBuffer
            #if defined(NEVER)
            RWByteAddressBuffer _B;
            WORDS _C;
            #else
            RWStructuredBuffer<uint> _B;
            WORDS _C;
            #endif
            """;
        ComputeShader shader = Kernel(declaration, "_B[0] = 7; _C.Store(4, 8);");
        using var structured = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 4);
        using var raw = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 4);
        shader.SetBuffer(0, "_B", structured);
        shader.SetBuffer(0, "_C", raw);
        Assert.That(Run(shader), Is.Empty);
        var read = new uint[4];
        raw.GetData(read);
        Assert.That(read[1], Is.EqualTo(8));
    }

    [Test]
    public void ABufferSetForAllShadersIsHeldToItToo()
    {
        ComputeShader shader = Kernel("RWStructuredBuffer<uint> _GlobalB;", "_GlobalB[0] = 1;");
        using var buffer = new GraphicsBuffer(Arguments, 4, 4);
        Shader.SetGlobalBuffer("_GlobalB", buffer);
        Assert.That(Run(shader), Has.Length.EqualTo(1));
    }

    [Test]
    public void ADrawWithAnotherViewIsSkippedAndSaysSo()
    {
        Material material = MaterialOf("""
            Shader "Test/View"
            {
                SubShader
                {
                    Pass
                    {
                        HLSLPROGRAM
                        #pragma vertex Vertex
                        #pragma fragment Fragment
                        #pragma target 4.5
                        StructuredBuffer<float4> _Places;
                        float4 Vertex(uint id : SV_VertexID) : SV_POSITION { return _Places[id]; }
                        float4 Fragment() : SV_Target { return 1; }
                        ENDHLSL
                    }
                }
            }
            """);
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 3, 16) { name = "Places" };
        material.SetBuffer("_Places", buffer);
        Graphics.RenderPrimitives(new RenderParams(material) { worldBounds = new Bounds(Vector3.zero, Vector3.one) }, MeshTopology.Triangles, 3);
        Frame();
        Assert.That(TakeErrors(), Has.One.Contains("Test/View").And.One.Contains("'_Places' is declared as a StructuredBuffer of 16 bytes"));
    }

    [Test]
    public void OnlyBuffersForArgumentsHoldThem()
    {
        ComputeShader shader = Kernel("RWStructuredBuffer<uint> _B;", "_B[0] = 1;");
        using GraphicsBuffer values = Floats(0, 0, 0, 0);
        using var arguments = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 4) { name = "Groups" };
        shader.SetBuffer(0, "_B", values);
        shader.DispatchIndirect(0, arguments);
        Assert.That(TakeErrors(), Has.One.Contains("buffer 'Groups' was created as Structured").And.One.Contains("add IndirectArguments"));
    }

    private string[] Dispatch(string declaration, string use, GraphicsBuffer buffer)
    {
        using (buffer)
        {
            ComputeShader shader = Kernel(declaration, use);
            shader.SetBuffer(0, "_B", buffer);
            return Run(shader);
        }
    }

    private ComputeShader Kernel(string declaration, string use) => Compute(
        $"#pragma kernel K\n{declaration}\nRWStructuredBuffer<uint> _Out;\n[numthreads(1, 1, 1)] void K() {{ _Out[1] = 5; {use} }}");

    private string[] Run(ComputeShader shader)
    {
        using var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 4);
        shader.SetBuffer(0, "_Out", output);
        shader.Dispatch(0, 1, 1, 1);
        string[] errors = TakeErrors();
        var written = new uint[4];
        output.GetData(written);
        Assert.That(written[1], Is.EqualTo(errors.Length == 0 ? 5u : 0u), "a dispatch that fails does nothing");
        return errors;
    }
}
