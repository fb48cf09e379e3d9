using Headless.Engine;
using NUnit.Framework;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Profiling;

namespace Headless.Tests.UnityEngineApi;

public class ProfilerTests : EngineFixture
{
    [Test]
    public void ARecorderSeesTheMarkerOfTheLastFrame()
    {
        var marker = new ProfilerMarker(ProfilerCategory.Scripts, "U.Work");
        using ProfilerRecorder recorder = ProfilerRecorder.StartNew(marker, 4);
        ActionProbe.Create().onUpdate = () =>
        {
            using (marker.Auto()) System.Threading.Thread.Sleep(2);
        };
        Frame(2);
        Assert.That(recorder.Valid && recorder.Count == 2, Is.True);
        Assert.That(recorder.LastValue, Is.GreaterThan(1_000_000));
        Assert.That(recorder.GetSample(0).Count, Is.EqualTo(1));
        Assert.That(recorder.UnitType, Is.EqualTo(ProfilerMarkerDataUnit.TimeNanoseconds));
        Assert.That(Recorder.Get("U.Work").sampleBlockCount, Is.EqualTo(1));
    }

    [Test]
    public void DeviceTimeAppearsAsGpuValues()
    {
        using ProfilerRecorder recorder = ProfilerRecorder.StartNew(ProfilerCategory.Render, "U.Pass", 1, ProfilerRecorderOptions.Default | ProfilerRecorderOptions.GpuRecorder);
        EngineHooks.EndFrame = () => ProfilerMarkerData.Of("U.Pass").AddGpu(1_500_000, 1);
        Frame();
        Assert.That(recorder.LastValue, Is.EqualTo(1_500_000));
        Recorder old = Recorder.Get("U.Pass");
        Assert.That(old.gpuElapsedNanoseconds, Is.EqualTo(1_500_000));
        Assert.That(old.gpuSampleBlockCount, Is.EqualTo(1));
    }
}
