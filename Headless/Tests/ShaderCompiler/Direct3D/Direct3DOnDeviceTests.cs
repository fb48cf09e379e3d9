using Headless.Shaders;
using Headless.Tests.Vulkan;
using Headless.Vulkan;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>The device runs what Direct3D's compiler made.</summary>
public sealed class Direct3DOnDeviceTests : DeviceFixture
{
    private const int Threads = 64;

    // Compiler 6.3.9600 folds "mask << v" into one bit-field insert of one bit and loses the second condition: where only that one
    // holds, mask << v becomes 0.
    private const string Miscompiled = """
        StructuredBuffer<float> _In; RWStructuredBuffer<uint> _Out;
        [numthreads(64, 1, 1)] void CS(uint i : SV_DispatchThreadID)
        {
            uint mask = _In[i] < 1.0 ? 1u : 0u;
            mask |= _In[i + 64u] < 1.0 ? 2u : 0u;
            _Out[i] = mask << (i & 15u);
        }
        """;

    // Each pair of values: both below 1, one of them, none.
    private static readonly float[] pairs =
        [.. Enumerable.Range(0, 2 * Threads).Select(i => ((i < Threads ? i : i / 2) & 1) == 0 ? 0f : 2f)];

    [Test]
    public void TheKnownFaultOfItsCompilerShows()
    {
        uint[] right = [.. Enumerable.Range(0, Threads).Select(i => Mask(i) << (i & 15))];

        Assert.That(Run(Miscompiled, null, pairs), Is.EqualTo(right), "glslang");
        uint[] found = Run(Miscompiled, Direct3DTools.Require(), pairs);
        Assert.That(found, Is.Not.EqualTo(right), "FXC has no such fault any more, or another compiler made the code");
        Assert.That(found, Is.EqualTo(right.Select((r, i) => (Mask(i) & 1) << (i & 15))), "the fault is another one");
    }

    [Test]
    public void AProductInPlaceOfTheShiftIsRight()
    {
        string source = Miscompiled.Replace("mask << (i & 15u)", "mask * (1u << (i & 15u))", StringComparison.Ordinal);
        uint[] right = [.. Enumerable.Range(0, Threads).Select(i => Mask(i) << (i & 15))];

        Assert.That(Run(source, Direct3DTools.Require(), pairs), Is.EqualTo(right));
    }

    [Test]
    public void BuffersHaveDirect3DsLayout()
    {
        const string source = """
            struct S { float3 p; uint n[2]; };
            StructuredBuffer<S> _In; RWStructuredBuffer<uint> _Out; uint _Offset[2]; float3 _Size;
            [numthreads(64, 1, 1)] void CS(uint i : SV_DispatchThreadID)
            {
                S s = _In[(i + _Offset[1]) % 8];
                uint count, stride;
                _In.GetDimensions(count, stride);
                _Out[i] = (uint)s.p.y + 1000 * s.n[1] + 1000000 * count + 100000000 * stride + (uint)_Size.z;
            }
            """;
        // The constant at byte b is b / 4 as an integer, the float at word w of the buffer is w: _Offset[1] begins at byte 16,
        // _Size takes the rest of that row.
        float[] words = [.. Enumerable.Range(0, 40).Select(w => w % 5 < 3 ? w : BitConverter.UInt32BitsToSingle((uint)w))];
        uint[] found = Run(source, Direct3DTools.Require(), words, ("_Offset[1]", 3u), ("_Size.z", 5f));

        Assert.That(found, Is.EqualTo(Enumerable.Range(0, Threads).Select(i =>
        {
            int first = (i + 3) % 8 * 5;
            return (uint)(first + 1 + 1000 * (first + 4) + 1000000 * 8 + 100000000 * 20 + 5);
        })));
    }

    [Test]
    public void SharedMemoryBarriersAndAtomicsWork()
    {
        const string source = """
            StructuredBuffer<uint> _In; RWStructuredBuffer<uint> _Out; groupshared uint sums[64]; groupshared uint largest;
            [numthreads(64, 1, 1)] void CS(uint i : SV_GroupIndex)
            {
                if (i == 0) largest = 0;
                sums[i] = _In[i];
                GroupMemoryBarrierWithGroupSync();
                for (uint step = 1; step < 64; step *= 2)
                {
                    uint before = i >= step ? sums[i - step] : 0;
                    GroupMemoryBarrierWithGroupSync();
                    sums[i] += before;
                    GroupMemoryBarrierWithGroupSync();
                }
                InterlockedMax(largest, _In[i]);
                uint place;
                InterlockedAdd(_Out[64], 1, place);
                InterlockedOr(_Out[65 + place / 32], 1u << (place & 31));
                GroupMemoryBarrierWithGroupSync();
                _Out[i] = sums[i] + largest * 65536;
            }
            """;
        uint[] values = [.. Enumerable.Range(0, Threads).Select(i => (uint)(i * 37 % 64))];
        uint[] found = Run(source, Direct3DTools.Require(), values);
        uint sum = 0;
        uint[] expected = [.. values.Select(v => sum += v).Select(s => s + 63 * 65536), Threads, uint.MaxValue, uint.MaxValue];

        Assert.That(found, Is.EqualTo(expected));
    }

    // Direct3D 11.3 functional specification, "ftoi" and "ftou".
    [Test]
    public void IntegersOfFloatsOutsideTheirRangeAreDirect3Ds()
    {
        const string source = """
            StructuredBuffer<float> _In; RWStructuredBuffer<uint> _Out;
            [numthreads(64, 1, 1)] void CS(uint i : SV_DispatchThreadID)
            {
                const float2 both = float2(_In[i % 8], _In[7 - i % 8]);
                const int2 signs = int2(both);
                _Out[i] = i < 8 ? uint(signs.x) : i < 16 ? uint(signs.y) : uint(both.x);
            }
            """;
        float[] values = [1e20f, -1e20f, float.NaN, 3e9f, -1.5f, 7.9f, float.PositiveInfinity, 2147483520f];
        uint[] found = Run(source, Direct3DTools.Require(), values);
        uint[] signed = [int.MaxValue, 0x80000000u, 0, int.MaxValue, unchecked((uint)-1), 7, int.MaxValue, 2147483520];

        Assert.That(found[..8], Is.EqualTo(signed));
        Assert.That(found[8..16], Is.EqualTo(signed.Reverse()));
        Assert.That(found[16..24], Is.EqualTo(new uint[] { uint.MaxValue, 0, 0, 3000000000, 0, 7, uint.MaxValue, 2147483520 }));
    }

    // (a + b) - a is 0 only where both steps are rounded; a product and a sum in one step differ from two.
    [Test]
    public void WhatIsPreciseStaysSo()
    {
        const string source = """
            StructuredBuffer<float> _In; RWStructuredBuffer<uint> _Out;
            [numthreads(64, 1, 1)] void CS(uint i : SV_DispatchThreadID)
            {
                const float a = _In[i], b = _In[i + 64];
                precise const float product = a * b - 1.0;
                precise const float sum = (a + b * 1e-8) - a;
                _Out[i] = i % 2 == 0 ? asuint(product) : asuint(sum);
            }
            """;
        float[] values = [.. Enumerable.Range(0, 2 * Threads).Select(i => 1f + (i % Threads * 31 % 64 + 1) * 0.0137f)];
        uint[] found = Run(source, Direct3DTools.Require(), values);

        Assert.That(found, Is.EqualTo(Enumerable.Range(0, Threads).Select(i =>
        {
            float a = values[i], b = values[i + Threads];
            float product = a * b, part = b * 1e-8f, sum = a + part;
            return BitConverter.SingleToUInt32Bits(i % 2 == 0 ? product - 1f : sum - a);
        })));
    }

    // FXC multiplies by 1 / b for the operator, so that the last bits differ.
    [TestCase("fmod(_In[i], _In[i + 64])", 0f)]
    [TestCase("fmod(_In[i], float2(_In[i + 64], 2)).x", 0f)]
    [TestCase("_In[i] % _In[i + 64]", 1e-4f)]
    public void FloatRemaindersAreTheSameByBothCompilers(string remainder, float tolerance)
    {
        string source = $$"""
            StructuredBuffer<float> _In; RWStructuredBuffer<uint> _Out;
            [numthreads(64, 1, 1)] void CS(uint i : SV_DispatchThreadID) { _Out[i] = asuint({{remainder}}); }
            """;
        float[] values = [.. Enumerable.Range(0, 2 * Threads).Select(i => (i * 37 % 128 - 63.6f) * (i < Threads ? 1f : 0.07f))];
        float[] found = [.. Run(source, null, values).Select(BitConverter.UInt32BitsToSingle)];
        float[] direct3D = [.. Run(source, Direct3DTools.Require(), values).Select(BitConverter.UInt32BitsToSingle)];

        Assert.That(found, Is.EqualTo(direct3D).Within(tolerance));
        float[] exact = [.. Enumerable.Range(0, Threads).Select(i => values[i] % values[i + Threads])];
        Assert.That(found, Is.EqualTo(exact).Within(1e-4f), "C#'s remainder has the dividend's sign too");
    }

    private static uint Mask(int i) => (pairs[i] < 1 ? 1u : 0u) | (pairs[i + Threads] < 1 ? 2u : 0u);

    /// <summary>What the kernel writes to _Out; the constants are given by "name", "name[index]" or "name.z".</summary>
    private uint[] Run<T>(string source, Direct3DFrontEnd? direct3D, T[] input, params (string Name, object Value)[] constants)
        where T : unmanaged
    {
        using ShaderSandbox sandbox = new() { Direct3D = direct3D };
        ShaderBinary kernel = sandbox.Kernel(source);
        Assert.That(kernel.ByDirect3D, Is.EqualTo(direct3D is not null));
        using GpuBuffer first = StorageBuffer<T>(input);
        using GpuBuffer output = StorageBuffer<uint>(new uint[source.Contains("_Out[65", StringComparison.Ordinal) ? Threads + 3 : Threads]);
        ResourceBindings bindings = new();
        foreach (ShaderResource resource in kernel.Resources)
        {
            if (resource.Kind == ResourceKind.ConstantBuffer)
            {
                bindings.SetUniform(0, resource.Binding, Constants(resource, constants));
            }
            else
            {
                bindings.SetBuffer(0, resource.Binding, resource.Name == "_Out" ? output : first);
            }
        }
        Recorder.Dispatch(Device.GetComputePipeline(kernel), bindings, 1, 1, 1);
        return Read<uint>(output);
    }

    private static byte[] Constants(ShaderResource buffer, (string Name, object Value)[] values)
    {
        byte[] bytes = new byte[buffer.Size];
        foreach ((string name, object value) in values)
        {
            ConstantMember member = buffer.Members.Single(m => m.Name == name.Split('[', '.')[0]);
            int at = member.Offset;
            if (name.Contains('['))
            {
                at += member.ArrayStride * int.Parse(name.Split('[', ']')[1]);
            }
            if (name.Contains('.'))
            {
                at += 4 * "xyzw".IndexOf(name[^1]);
            }
            BitConverter.TryWriteBytes(bytes.AsSpan(at), value is float number ? BitConverter.SingleToUInt32Bits(number) : (uint)value);
        }
        return bytes;
    }
}
