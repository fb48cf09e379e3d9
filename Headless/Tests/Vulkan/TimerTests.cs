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

    // 5 ticks in one submission and 7 in the next, which began 1,000 later; the clock of 8 bits starts again between 253 and 4.
    [Test]
    public void AScopeHasTheTimeOfItsPartsWithoutWhatLiesBetweenSubmissions([Values(8, 36, 64)] int bits)
    {
        TimestampClock clock = new(100, bits);
        TimerScope scope = new(1, "cut", 0);
        foreach ((ulong begin, ulong end) in new[] { (10UL, 15UL), bits == 8 ? (253UL, 4UL) : (1015UL, 1022UL) })
        {
            scope.Await();
            scope.Await();
            scope.Take(begin, isEnd: false, clock);
            Assert.That(scope.IsDone, Is.False);
            scope.Take(end, isEnd: true, clock);
        }

        scope.IsOpen = false;
        Assert.That(scope.IsDone, Is.True);
        Assert.That(scope.Result(clock).Milliseconds, Is.EqualTo(12 * 100e-6).Within(1e-9));
    }

    [Test]
    public void ALaterTimestampThatTheDeviceTookFirstIsNoTime([Values(36, 64)] int bits) =>
        Assert.That(new TimestampClock(1, bits).Between(1000, 990), Is.Zero);

    [Test]
    public void ScopesThatNothingIsRecordedInAfterASubmissionEndWithIt()
    {
        using GpuBuffer buffer = StorageBuffer(256);
        int outer = Recorder.BeginTimer("outer");
        int inner = Recorder.BeginTimer("inner");
        Work(buffer);
        ulong ticket = Recorder.Submit();
        Recorder.EndTimer(inner);
        Recorder.EndTimer(outer);
        Assert.That(Recorder.Submit(), Is.EqualTo(ticket), "nothing was left to submit");
        Device.WaitIdle();
        Assert.That(Device.CollectTimers().Select(timer => timer.Name), Is.EqualTo(new[] { "outer", "inner" }));
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
