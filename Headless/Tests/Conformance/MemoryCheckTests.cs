using Headless.Engine;
using Headless.Vulkan;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;

namespace Headless.Tests.Conformance;

/// <summary>A device that poisons new memory and checks every index.</summary>
public sealed class MemoryCheckTests : HlslFixture
{
    protected override GpuDeviceOptions Options => base.Options with { Poison = true, CheckBounds = true };

    [TearDown]
    public void ForgetFaults() => GraphicsDevice.Device.TakeOutOfBounds();

    [Test]
    public void NewBuffersHoldNaN()
    {
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 5, 4);
        Assert.That(Read(buffer), Is.All.NaN);
        buffer.SetData(new float[5]);
        using var next = new ComputeBuffer(5, 4);
        var words = new uint[5];
        next.GetData(words);
        Assert.That(words, Is.All.EqualTo(uint.MaxValue));
    }

    [TestCase(RenderTextureFormat.ARGBFloat)]
    [TestCase(RenderTextureFormat.ARGBHalf)]
    [TestCase(RenderTextureFormat.RFloat)]
    public void NewRenderTexturesHoldNaN(RenderTextureFormat format)
    {
        var texture = new RenderTexture(4, 4, 0, format);
        using GraphicsBuffer result = Floats(0);
        ComputeShader shader = Compute("""
            #pragma kernel Main
            Texture2D _Texture;
            RWStructuredBuffer<float> _Result;
            [numthreads(1, 1, 1)] void Main() { _Result[0] = isnan(_Texture[uint2(3, 3)].x) ? 1 : 0; }
            """);
        shader.SetTexture(0, "_Texture", texture);
        shader.SetBuffer(0, "_Result", result);
        shader.Dispatch(0, 1, 1, 1);
        Assert.That(Read(result)[0], Is.EqualTo(1f));
        texture.Release();
    }

    [Test]
    public void AReusedTemporaryIsPoisonedAnew()
    {
        RenderTexture first = RenderTexture.GetTemporary(4, 4, 0, RenderTextureFormat.ARGBFloat);
        Clear(first);
        Assert.That(Pixel(first).x, Is.EqualTo(0.5f));
        RenderTexture.ReleaseTemporary(first);
        RenderTexture second = RenderTexture.GetTemporary(4, 4, 0, RenderTextureFormat.ARGBFloat);
        Assert.That(second, Is.SameAs(first), "the pool handed out another one");
        Assert.That(Pixel(second).x, Is.NaN);
        Clear(second);
        second.DiscardContents();
        Assert.That(Pixel(second).x, Is.NaN);
        RenderTexture.ReleaseTemporary(second);
    }

    [Test]
    public void UninitialisedNativeMemoryHoldsSetBitsAndClearedMemoryZeros()
    {
        using var left = new NativeArray<float>(3, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
        using var cleared = new NativeArray<float>(3, Allocator.Temp);
        Assert.That(left.ToArray(), Is.All.NaN);
        Assert.That(cleared.ToArray(), Is.All.Zero);
    }

    /// <summary>Scalars, arrays of an awkward length, arrays of arrays and structs; integers see every bit set.</summary>
    [Test]
    public void GroupsharedMemoryBeginsPoisoned()
    {
        const string source = """
            struct Cell { float3 a; uint b; int c[2]; };
            groupshared float single;
            groupshared float list[131];
            groupshared int2 table[3][5];
            groupshared Cell cells[65];
            [numthreads(8, 4, 2)] void Main(uint t : SV_GroupIndex)
            {
                _Result[t] = isnan(single) && isnan(list[t]) && isnan(list[t + 64]) && isnan(list[128 + t % 3]) ? 1 : 0;
                int2 both = table[t % 3][t % 5];
                _Result[t + 64] = both.x == -1 && both.y == -1 ? 1 : 0;
                Cell cell = cells[t + 1];
                _Result[t + 128] = isnan(cell.a.y) && cell.b == 0xffffffff && cell.c[1] == -1 ? 1 : 0;
                GroupMemoryBarrierWithGroupSync();
                list[t] = t;
                GroupMemoryBarrierWithGroupSync();
                _Result[t + 192] = list[63 - t];
            }
            """;
        float[] found = RunKernel(source, 256);
        Assert.That(found[..192], Is.All.EqualTo(1f));
        Assert.That(found[192..], Is.EqualTo(Enumerable.Range(0, 64).Select(t => 63f - t)));
    }

    [Test]
    public void AnIndexInsideIsNoFault()
    {
        Run("groupshared uint g[4]; float4 v;", "float a[3] = { 1, 2, 3 }; g[3] = 2; _Result[1] = a[g[3]] + v[g[3]];", 2);
        Assert.That(GraphicsDevice.Device.TakeOutOfBounds(), Is.Empty);
    }

    [TestCase("_Result[at] = 1;", 7, "_Result", 2)]
    [TestCase("_Result[0] = _Result[at];", -1, "_Result", 2)]
    [TestCase("g[at] = 1; _Result[0] = g[0];", 4, "g", 4)]
    [TestCase("float a[3] = { 1, 2, 3 }; _Result[0] = a[at];", 3, "an array", 3)]
    [TestCase("_Result[0] = at < 2 ? _Result[at] : 0;", 9, "_Result", 2)]
    public void AnIndexOutsideIsNamedWithKernelAndVariable(string body, int at, string variable, int length)
    {
        Run("groupshared float g[4]; int at;", body, 2, shader => shader.SetInt("at", at));
        string fault = GraphicsDevice.Device.TakeOutOfBounds().Single();
        Assert.That(fault, Does.StartWith($"Out of bounds in 'Main': element {at} of '{variable}', which has {length} (1 threads"));
        Assert.That(GraphicsDevice.Device.TakeOutOfBounds(), Is.Empty, "named once");
    }

    [Test]
    public void AnAtomicAndARawAccessOutsideAreNamed()
    {
        RunKernel(
            "RWByteAddressBuffer _Raw; [numthreads(2, 1, 1)] void Main(uint t : SV_GroupIndex) { uint old; _Raw.InterlockedAdd(16, 1, old); _Result[t] = 0; }", 2,
            shader => shader.SetBuffer(0, "_Raw", new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 4)));
        Assert.That(GraphicsDevice.Device.TakeOutOfBounds().Single(), Does.Contain("element 4 of '_Raw', which has 4 (2 threads"));
    }

    private static void Clear(RenderTexture texture)
    {
        using var commands = new UnityEngine.Rendering.CommandBuffer();
        commands.SetRenderTarget(texture);
        commands.ClearRenderTarget(false, true, new Color(0.5f, 0, 0, 0));
        Graphics.ExecuteCommandBuffer(commands);
    }

    private static Vector4 Pixel(RenderTexture texture)
    {
        var request = UnityEngine.Rendering.AsyncGPUReadback.Request(texture, 0, TextureFormat.RGBAFloat);
        request.WaitForCompletion();
        return request.GetData<Vector4>()[0];
    }
}
