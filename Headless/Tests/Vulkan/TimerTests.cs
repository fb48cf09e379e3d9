using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class TimerTests : DeviceFixture
{
    [SetUp]
    public void NeedTimestamps()
    {
        if (!Device.Limits.Timestamps)
        {
            Assert.Ignore($"{Device.Adapter.Name} has no timestamps");
        }

        Device.WaitIdle();
        Device.CollectTimers();
    }

    [Test]
    public void ScopesNestAndTakeTime()
    {
        using GpuBuffer buffer = StorageBuffer(1 << 22);
        int outer = Recorder.BeginTimer("outer");
        int first = Recorder.BeginTimer("first");
        Work(buffer);
        Recorder.EndTimer(first);
        int second = Recorder.BeginTimer("second");
        Work(buffer);
        Recorder.EndTimer(second);
        Recorder.EndTimer(outer);
        Device.WaitIdle();

        IReadOnlyList<TimerResult> timers = Device.CollectTimers();

        Assert.That(timers.Select(timer => (timer.Name, timer.Depth)), Is.EqualTo(new[] { ("outer", 0), ("first", 1), ("second", 1) }));
        Assert.That(timers.Select(timer => timer.Milliseconds), Is.All.GreaterThan(0));
        Assert.That(timers[0].Milliseconds, Is.GreaterThanOrEqualTo(timers[1].Milliseconds + timers[2].Milliseconds - 1e-6));
        Assert.That(Device.CollectTimers(), Is.Empty);
    }

    [Test]
    public void ScopesMaySpanSubmissions()
    {
        using GpuBuffer buffer = StorageBuffer(1 << 16);
        int timer = Recorder.BeginTimer("long");
        for (int i = 0; i < 3; i++)
        {
            Work(buffer);
            Recorder.Submit();
        }

        Work(buffer);
        Recorder.EndTimer(timer);
        Device.WaitIdle();
        Assert.That(Device.CollectTimers().Single().Milliseconds, Is.GreaterThan(0));
    }

    // Without a dependence a rasterizer on the CPU would take both of the inner scope's timestamps after its work.
    [Test]
    public void WorkIsTimedInItsOwnScope()
    {
        using GpuBuffer small = StorageBuffer(256);
        using GpuBuffer large = StorageBuffer(1 << 22);
        int outer = Recorder.BeginTimer("outer");
        Work(small);
        int inner = Recorder.BeginTimer("inner");
        Work(large);
        Recorder.EndTimer(inner);
        Recorder.EndTimer(outer);
        Device.WaitIdle();

        IReadOnlyList<TimerResult> timers = Device.CollectTimers();

        Assert.That(timers[1].Milliseconds, Is.GreaterThan(0.5 * timers[0].Milliseconds));
    }

    [Test]
    public void MoreScopesThanASubmissionHoldsAreAllTimed()
    {
        using GpuBuffer buffer = StorageBuffer(256);
        for (int i = 0; i < 5000; i++)
        {
            int timer = Recorder.BeginTimer("many");
            Work(buffer);
            Recorder.EndTimer(timer);
        }

        Device.WaitIdle();
        Assert.That(Device.CollectTimers(), Has.Count.EqualTo(5000));
    }

    [Test]
    public void ScopesCloseInReverseOrder()
    {
        int outer = Recorder.BeginTimer("outer");
        int inner = Recorder.BeginTimer("inner");
        Assert.That(() => Recorder.EndTimer(outer), Throws.InvalidOperationException);
        Recorder.EndTimer(inner);
        Recorder.EndTimer(outer);
    }

    private void Work(GpuBuffer buffer)
    {
        uint count = (uint)(buffer.Size / 4);
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(count, 1, buffer), Kernels.Groups(count), 1, 1);
    }
}
