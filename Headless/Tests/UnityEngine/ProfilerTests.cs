using Headless.Engine;
using NUnit.Framework;
using Unity.Profiling;
using Unity.Profiling.LowLevel;
using Unity.Profiling.LowLevel.Unsafe;
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

    [Test]
    public unsafe void ACountersValueIsTakenAtTheFramesEndAndSetToZero()
    {
        long* value = Counter("U.Counter", ProfilerCounterOptions.FlushOnEndOfFrame | ProfilerCounterOptions.ResetToZeroOnFlush, out _);
        using ProfilerRecorder recorder = ProfilerRecorder.StartNew(new ProfilerCategory("U"), "U.Counter", 4);
        ActionProbe.Create().onUpdate = () => *value += 7;
        Frame(2);
        Assert.That(recorder.Count, Is.EqualTo(2));
        Assert.That(recorder.GetSample(0).Value, Is.EqualTo(7));
        Assert.That(recorder.LastValue, Is.EqualTo(7));
        Assert.That(recorder.UnitType, Is.EqualTo(ProfilerMarkerDataUnit.Bytes));
        Assert.That(*value, Is.Zero);
    }

    [Test]
    public unsafe void ACounterWithoutOptionsKeepsItsValueAndIsTakenWhenFlushed()
    {
        long* value = Counter("U.Kept", ProfilerCounterOptions.None, out _);
        using ProfilerRecorder recorder = ProfilerRecorder.StartNew(new ProfilerCategory("U"), "U.Kept");
        *value = 5;
        Frame();
        Assert.That(recorder.LastValue, Is.Zero);
        ProfilerUnsafeUtility.FlushCounterValue(value);
        Frame();
        Assert.That(recorder.LastValue, Is.EqualTo(5));
        Assert.That(*value, Is.EqualTo(5));
    }

    [Test]
    public void CountersOfOtherThanWholeNumbersAreRefused() => Assert.That(() => Create("U.Float", ProfilerMarkerDataType.Float, 4), Throws.TypeOf<NotSupportedException>());

    [Test]
    public void ASizeThatIsNotTheTypesIsRefused() => Assert.That(() => Create("U.Size", ProfilerMarkerDataType.Int64, 4), Throws.ArgumentException);

    static unsafe long* Counter(string name, ProfilerCounterOptions options, out IntPtr handle) => (long*)ProfilerUnsafeUtility.CreateCounterValue(
        out handle, name, new ProfilerCategory("U"), MarkerFlags.Default, (byte)ProfilerMarkerDataType.Int64, (byte)ProfilerMarkerDataUnit.Bytes, sizeof(long), options);

    static unsafe void Create(string name, ProfilerMarkerDataType type, int size) =>
        ProfilerUnsafeUtility.CreateCounterValue(out _, name, new ProfilerCategory("U"), MarkerFlags.Default, (byte)type, 0, size, ProfilerCounterOptions.None);
}
