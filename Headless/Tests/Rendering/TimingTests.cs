using Headless.Engine;
using NUnit.Framework;
using Unity.Profiling;
using Unity.Profiling.LowLevel;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class TimingTests : RenderFixture
{
    [Test]
    public void MarkersBecomeGpuTimes()
    {
        GpuTimings.Finished += Nothing;
        ComputeShader shader = Compute("""
            #pragma kernel Main
            RWStructuredBuffer<float> _Values;
            [numthreads(64, 1, 1)]
            void Main(uint3 id : SV_DispatchThreadID)
            {
                float x = id.x;
                for (uint i = 0; i < 200; i++) x = sin(x) + 1;
                _Values[id.x] = x;
            }
            """);
        using var values = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 65536, 4);
        var marker = new ProfilerMarker(ProfilerCategory.Render, "HeavyTest", MarkerFlags.SampleGPU);
        using var commands = new CommandBuffer();
        commands.BeginSample("OuterTest");
        for (int i = 0; i < 3; i++)
        {
            commands.BeginSample(marker);
            commands.SetComputeBufferParam(shader, 0, "_Values", values);
            commands.DispatchCompute(shader, 0, 1024, 1, 1);
            commands.EndSample(marker);
        }

        commands.EndSample("OuterTest");
        GpuTimings.Reset();
        Graphics.ExecuteCommandBuffer(commands);
        GraphicsDevice.Device.WaitIdle();
        Frame();
        (double inner, int count) = GpuTimings.Total["HeavyTest"];
        (double outer, _) = GpuTimings.Total["OuterTest"];
        Assert.That(count, Is.EqualTo(3));
        Assert.That(inner, Is.GreaterThan(0.0));
        Assert.That(outer, Is.GreaterThanOrEqualTo(inner * 0.9));
        Assert.That(GpuTimings.TotalMilliseconds, Is.EqualTo(outer).Within(1e-6), "only outermost scopes are summed");
    }

    [Test]
    public void OnlyMarkersThatARecorderListensToAreTimed()
    {
        const ProfilerRecorderOptions Gpu = ProfilerRecorderOptions.Default | ProfilerRecorderOptions.GpuRecorder;
        using ProfilerRecorder heard = ProfilerRecorder.StartNew(ProfilerCategory.Render, "HeardTest", 1, Gpu);
        using ProfilerRecorder stopped = ProfilerRecorder.StartNew(ProfilerCategory.Render, "StoppedTest", 1, Gpu);
        using ProfilerRecorder processor = ProfilerRecorder.StartNew(ProfilerCategory.Render, "ProcessorTest");
        stopped.Stop();
        using var commands = new CommandBuffer();
        foreach (string marker in new[] { "HeardTest", "StoppedTest", "ProcessorTest", "UnheardTest" })
        {
            commands.BeginSample(marker);
            commands.EndSample(marker);
        }

        GpuTimings.Reset();
        Graphics.ExecuteCommandBuffer(commands);
        GraphicsDevice.Device.WaitIdle();
        Frame();
        Assert.That(GpuTimings.Total.Keys, Is.EqualTo(new[] { "HeardTest" }));
    }

    [TearDown]
    public void StopListening() => GpuTimings.Finished -= Nothing;

    private static void Nothing(string marker, double milliseconds)
    {
    }

    [Test]
    public void SamplesMustNest()
    {
        using var commands = new CommandBuffer();
        commands.BeginSample("Left open");
        commands.EndSample("Other");
        Graphics.ExecuteCommandBuffer(commands);
        Assert.That(TakeErrors(), Has.Exactly(2).Items);
    }
}
