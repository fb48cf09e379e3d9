using NUnit.Framework;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

/// <summary>Shaders that branch and loop by their constants: what they compute, and that each is compiled once, whatever the constants are.</summary>
public sealed class ConstantConditionTests : DrawFixture
{
    // Long enough for drivers to think that the values written in would make it shorter.
    private const string Sum = """
        float Sum(float4 at, int count, float level)
        {
            float4 sum = at;
            for (int i = 0; i < count; i++) sum = sin(sum.yzwx * 1.7 + cos(sum) * level) + sqrt(abs(sum.wzyx)) + exp2(-abs(sum.xzyw));
            if (level > 0.5)
            {
                sum = tan(sum) + log2(1 + abs(sum.zxyw)) * cos(sum * 3.1) + normalize(sum + 2).wxyz;
                sum += atan2(sum, sum.yzwx + 3) * rsqrt(1 + sum * sum) - frac(sum * 7) + pow(abs(sum), 1.3) + sin(sum * 0.3) * cos(sum * 0.7);
            }
            return dot(sum, float4(1, 2, 3, 4));
        }
        """;

    private const int WarmUp = 50, Draws = 100;

    [Test]
    public void ADrawThatGoesByItsConstantsIsCompiledOnce()
    {
        GpuRenderPipeline pipeline = Device.GetRenderPipeline(Pipeline(DrawShaders.FullScreen, TestShader.Stage(ShaderStage.Fragment, "Shade", $$"""
            [[vk::binding(0, 2)]] cbuffer Constants { int _Count; float _Level; };
            {{Sum}}
            float4 Shade(float4 position : SV_Position) : SV_Target { return Sum(position, _Count, _Level).xxxx; }
            """, TestShader.Uniform(0, 16))));
        Grows(i =>
        {
            BeginCleared();
            Recorder.Draw(pipeline, Set(2, i), 3);
            Recorder.EndRendering();
        });
    }

    [Test]
    public void AKernelThatGoesByItsConstantsIsCompiledOnce()
    {
        GpuComputePipeline pipeline = Device.GetComputePipeline(TestShader.Kernel("Work", 1, $$"""
            [[vk::binding(0, 0)]] cbuffer Constants { int _Count; float _Level; };
            [[vk::binding(1, 0)]] RWStructuredBuffer<float> _Result;
            {{Sum}}
            [numthreads(1, 1, 1)] void Work(uint3 id : SV_DispatchThreadID) { _Result[id.x] = Sum(float4(id, 1), _Count, _Level); }
            """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Result")));
        using GpuBuffer result = StorageBuffer(64);
        Grows(i =>
        {
            ResourceBindings bindings = Set(0, i);
            bindings.SetBuffer(0, 1, result, 0, result.Size);
            Recorder.Dispatch(pipeline, bindings, 16, 1, 1);
        });
    }

    [Test]
    public void TheyComputeWhatTheirConstantsSay()
    {
        GpuComputePipeline pipeline = Device.GetComputePipeline(TestShader.Kernel("Count", 1, """
            [[vk::binding(0, 0)]] cbuffer Constants { int _Count; float _Level; };
            [[vk::binding(1, 0)]] RWStructuredBuffer<int> _Result;
            [numthreads(1, 1, 1)] void Count(uint3 id : SV_DispatchThreadID)
            {
                int sum = id.x;
                for (int i = 0; i < _Count; i++) sum += 10;
                if (_Level > 2.5) sum += 1000; else sum += 2000;
                switch (_Count) { case 1: sum += 100000; break; case 4: sum += 400000; break; default: sum += 900000; break; }
                _Result[id.x] = sum;
            }
            """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Result")));
        using GpuBuffer result = StorageBuffer(8);
        foreach ((int count, float level, int expected) in new[] { (0, 0f, 902000), (1, 2.5f, 102010), (4, 3f, 401040), (7, float.NaN, 902070) })
        {
            ResourceBindings bindings = new();
            bindings.SetUniform(0, 0, Bytes(count, level));
            bindings.SetBuffer(0, 1, result, 0, result.Size);
            Recorder.Dispatch(pipeline, bindings, 2, 1, 1);
            Assert.That(Read<int>(result), Is.EqualTo(new[] { expected, expected + 1 }), $"{count} {level}");
        }
    }

    // 20 kB a draw; what a compilation leaves is some hundred.
    private void Grows(Action<int> work)
    {
        long before = 0;
        for (int i = 0; i < WarmUp + Draws; i++)
        {
            if (i == WarmUp)
            {
                before = Environment.WorkingSet;
            }

            work(i);
            Device.WaitIdle();
        }

        Assert.That((Environment.WorkingSet - before) / Draws, Is.LessThan(20 << 10), "bytes of the process a time");
    }

    private static ResourceBindings Set(int set, int i)
    {
        ResourceBindings bindings = new();
        bindings.SetUniform(set, 0, Bytes(2 + i % 5, i / 10f));
        return bindings;
    }

    private static byte[] Bytes(int count, float level) => [.. BitConverter.GetBytes(count), .. BitConverter.GetBytes(level), .. new byte[8]];
}
