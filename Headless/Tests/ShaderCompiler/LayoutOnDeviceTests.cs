using System.Runtime.InteropServices;
using Headless.Shaders;
using Headless.Tests.Vulkan;
using Headless.Vulkan;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>The device reads what a writer puts at D3D11's offsets: every word of a buffer holds its own index.</summary>
public sealed class LayoutOnDeviceTests : DeviceFixture
{
    [Test]
    public void ConstantBuffer()
    {
        Assert.That(Run(
            """
            struct Q { float3 a; };
            struct In { float x; Q q; float y; };
            cbuffer Params
            {
                float3 _A; float _B; float2 _Arr[3]; float _C; float3x3 _M3; float _D; Q _Q; float _E;
                float2x4 _M24; float _G; row_major float2x3 _R; float3 _V; In _In[2]; float _Tail;
            };
            """,
            "_A.z", "_B", "_Arr[2].y", "_C", "_M3[1][2]", "_D", "_Q.a.y", "_E", "_M24[1][3]", "_G", "_R[1][0]", "_V.x", "_In[1].q.a.z",
            "_In[1].y", "_Tail"),
            Is.EqualTo(new float[] { 2, 3, 13, 14, 25, 27, 29, 31, 45, 46, 52, 56, 74, 75, 76 }));
    }

    [Test]
    public void MatricesOfUnityMultiplyColumnVectors()
    {
        float[] expected = new float[4];
        float[] v = [1, 2, 3, 1];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                expected[row] += (column * 4 + row) * v[column];
            }
        }
        const string product = "mul(_M, float4(1, 2, 3, 1))";
        Assert.That(Run("float4x4 _M;", product + ".x", product + ".y", product + ".z", product + ".w"), Is.EqualTo(expected));
    }

    [TestCase("float3 a; float b[3]; float c;", new[] { "a.y", "b[2]", "c" }, new[] { 1, 5, 6 }, 7)]
    [TestCase("float2 a; row_major float3x2 m; float3x2 n;", new[] { "m[2][1]", "n[2][1]", "n[0][1]" }, new[] { 7, 13, 11 }, 14)]
    public void StructuredBuffer(string members, string[] read, int[] words, int stride)
    {
        string declarations = $$"""
            struct Element { {{members}} };
            StructuredBuffer<Element> _In;
            RWStructuredBuffer<Element> _Copy;
            """;
        string[] expressions = [.. read.Select(r => "_In[2]." + r), .. read.Select(r => "_Copy[1]." + r)];
        float[] expected = [.. words.Select(w => 2f * stride + w), .. words.Select(w => 1f * stride + w)];
        Assert.That(Run(declarations, expressions), Is.EqualTo(expected));
    }

    /// <summary>Values of expressions with every buffer filled with 0, 1, 2, ... as floats.</summary>
    private float[] Run(string declarations, params string[] expressions)
    {
        using ShaderSandbox sandbox = new();
        string stores = string.Concat(expressions.Select((e, i) => $"_Out[{i}] = {e};\n"));
        ShaderBinary kernel = sandbox.Kernel(
            $"{declarations}\nRWStructuredBuffer<float> _Out;\n[numthreads(1, 1, 1)] void CS()\n{{\n{stores}}}");
        float[] indices = [.. Enumerable.Range(0, 256).Select(i => (float)i)];
        ResourceBindings bindings = new();
        using GpuBuffer target = StorageBuffer(expressions.Length * 4);
        using GpuBuffer first = StorageBuffer<float>(indices);
        using GpuBuffer second = StorageBuffer<float>(indices);
        foreach (ShaderResource resource in kernel.Resources)
        {
            if (resource.Kind == ResourceKind.ConstantBuffer)
            {
                bindings.SetUniform(0, resource.Binding, MemoryMarshal.AsBytes(indices.AsSpan(0, resource.Size / 4)));
            }
            else
            {
                GpuBuffer buffer = resource.Name == "_Out" ? target : resource.Name == "_In" ? first : second;
                bindings.SetBuffer(0, resource.Binding, buffer);
            }
        }
        Recorder.Dispatch(Device.GetComputePipeline(kernel), bindings, 1, 1, 1);
        return Read<float>(target);
    }
}
