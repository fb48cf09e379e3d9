using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class ConstantTests : RenderFixture
{
    private const string Echo = """
        #pragma kernel Main
        float3 _Points[3];
        float4x4 _Matrix;
        float4x4 _Matrices[2];
        bool _Flag;
        int3 _Cell;
        float _Scalars[2];
        float4 _Vector;
        float3 _Three;
        float _After;
        RWStructuredBuffer<float> _Result;
        [numthreads(1, 1, 1)]
        void Main()
        {
            _Result[0] = _Points[0].x;
            _Result[1] = _Points[1].y;
            _Result[2] = _Points[2].z;
            float4 moved = mul(_Matrix, float4(1, 2, 3, 1));
            _Result[3] = moved.x;
            _Result[4] = moved.y;
            _Result[5] = moved.z;
            _Result[6] = mul(_Matrices[1], float4(1, 1, 1, 1)).y;
            _Result[7] = _Flag ? 1 : 0;
            _Result[8] = _Cell.x * 100 + _Cell.y * 10 + _Cell.z;
            _Result[9] = _Scalars[1];
            _Result[10] = _Vector.w;
            _Result[11] = _Three.z;
            _Result[12] = _After;
        }
        """;

    private static readonly Matrix4x4 Move = Matrix4x4.Translate(new Vector3(10f, 20f, 30f));

    private static readonly float[] Expected = [1, 5, 9, 11, 22, 33, 2, 1, 789, 4.5f, 0.25f, 6, 8];

    [Test]
    public void ValuesArriveInD3DLayout()
    {
        ComputeShader shader = Compute(Echo);
        using GraphicsBuffer result = Floats(new float[13]);
        shader.SetBuffer(0, "_Result", result);
        shader.SetVectorArray("_Points", [new Vector4(1, 2, 3), new Vector4(4, 5, 6), new Vector4(7, 8, 9)]);
        shader.SetMatrix("_Matrix", Move);
        shader.SetMatrixArray("_Matrices", [Matrix4x4.zero, Matrix4x4.Scale(new Vector3(1, 2, 3))]);
        shader.SetBool("_Flag", true);
        shader.SetInts("_Cell", 7, 8, 9);

        // Array elements begin 16 bytes apart, as every Unity user learns.
        shader.SetFloats("_Scalars", 3.5f, 0f, 0f, 0f, 4.5f);
        shader.SetVector("_Vector", new Vector4(0, 0, 0, 0.25f));
        shader.SetFloat("_After", 8f);
        shader.SetVector("_Three", new Vector4(4, 5, 6, 777));
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result), Is.EqualTo(Expected));
    }

    [Test]
    public void TheSameThroughACommandBuffer()
    {
        ComputeShader shader = Compute(Echo);
        using GraphicsBuffer result = Floats(new float[13]);
        using var commands = new CommandBuffer();
        Vector4[] points = [new Vector4(1, 2, 3), new Vector4(4, 5, 6), new Vector4(7, 8, 9)];
        commands.SetComputeBufferParam(shader, 0, "_Result", result);
        commands.SetComputeVectorArrayParam(shader, "_Points", points);
        commands.SetComputeMatrixParam(shader, "_Matrix", Move);
        commands.SetComputeMatrixArrayParam(shader, "_Matrices", [Matrix4x4.zero, Matrix4x4.Scale(new Vector3(1, 2, 3))]);
        commands.SetComputeIntParam(shader, "_Flag", 1);
        commands.SetComputeIntParams(shader, "_Cell", 7, 8, 9);
        commands.SetComputeFloatParams(shader, "_Scalars", 3.5f, 0f, 0f, 0f, 4.5f);
        commands.SetComputeVectorParam(shader, "_Vector", new Vector4(0, 0, 0, 0.25f));
        commands.SetComputeFloatParam(shader, "_After", 8f);
        commands.SetComputeVectorParam(shader, "_Three", new Vector4(4, 5, 6, 777));
        commands.DispatchCompute(shader, 0, 1, 1, 1);
        points[0] = Vector4.zero;
        Graphics.ExecuteCommandBuffer(commands);
        Assert.That(Read(result), Is.EqualTo(Expected));
    }

    [Test]
    public void AConstantBufferCanComeFromAGraphicsBuffer()
    {
        ComputeShader shader = Compute("""
            #pragma kernel Main
            cbuffer Settings { float _A; float _B; float2 _C; }
            RWStructuredBuffer<float> _Result;
            [numthreads(1, 1, 1)]
            void Main() { _Result[0] = _A + _B * 10 + _C.y * 100; }
            """);
        using GraphicsBuffer result = Floats(0f);
        using var settings = new GraphicsBuffer(GraphicsBuffer.Target.Constant, 4, sizeof(float));
        settings.SetData(new float[] { 1, 2, 3, 4 });
        shader.SetBuffer(0, "_Result", result);
        shader.SetConstantBuffer("Settings", settings, 0, 16);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result)[0], Is.EqualTo(421f));
    }

    [Test]
    public void GlobalValuesReachKernelsThatSetNoneThemselves()
    {
        ComputeShader shader = Compute("""
            #pragma kernel Main
            float _GlobalProbe;
            RWStructuredBuffer<float> _Result;
            [numthreads(1, 1, 1)]
            void Main() { _Result[0] = _GlobalProbe; }
            """);
        using GraphicsBuffer result = Floats(0f);
        shader.SetBuffer(0, "_Result", result);
        Shader.SetGlobalFloat("_GlobalProbe", 3f);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result)[0], Is.EqualTo(3f));
        shader.SetFloat("_GlobalProbe", 4f);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result)[0], Is.EqualTo(4f));
    }
}
