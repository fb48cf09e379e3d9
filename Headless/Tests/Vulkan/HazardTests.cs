using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class HazardTests : DeviceFixture
{
    private const uint Count = 5003;

    private GpuBuffer a = null!;
    private GpuBuffer b = null!;
    private GpuBuffer c = null!;
    private GpuBuffer unrelated = null!;

    [SetUp]
    public void CreateBuffers()
    {
        a = StorageBuffer(Count * 4, "a");
        b = StorageBuffer(Count * 4, "b");
        c = StorageBuffer(Count * 4, "c");
        unrelated = StorageBuffer(4, "unrelated");
        Recorder.FillBuffer(unrelated, 0, 4, 0);
    }

    [TearDown]
    public void FreeBuffers()
    {
        a.Dispose();
        b.Dispose();
        c.Dispose();
        unrelated.Dispose();
    }

    [Test]
    public void ReadAfterWriteWaits()
    {
        Fill(a, 1);
        Assert.That(Barriers(() => Reverse(b, a)), Is.EqualTo(1));
        Assert.That(Read<uint>(b)[0], Is.EqualTo(Count));
    }

    [Test]
    public void WriteAfterReadWaits()
    {
        Fill(a, 1);
        Reverse(b, a);
        Assert.That(Barriers(() => Fill(a, 1000)), Is.EqualTo(1));
        Assert.That(Read<uint>(b), Is.EqualTo(Enumerable.Range(0, (int)Count).Select(i => Count - (uint)i)));
        Assert.That(Read<uint>(a)[0], Is.EqualTo(1000u));
    }

    [Test]
    public void WriteAfterWriteWaits()
    {
        Fill(a, 1);
        Assert.That(Barriers(() => Fill(a, 2)), Is.EqualTo(1));
        Assert.That(Read<uint>(a)[0], Is.EqualTo(2u));
    }

    [Test]
    public void IndependentWritesDoNotWait() =>
        Assert.That(
            Barriers(() =>
            {
                Fill(a, 1);
                Fill(b, 2);
                Fill(c, 3);
            }),
            Is.Zero);

    [Test]
    public void ReadsDoNotWaitForReads()
    {
        Fill(a, 1);
        Reverse(b, a);
        Assert.That(Barriers(() => Reverse(c, a)), Is.Zero);
    }

    [Test]
    public void OneBarrierServesAllEarlierWrites()
    {
        Fill(a, 1);
        Fill(b, 1);
        Assert.That(Barriers(() => Reverse(c, a)), Is.EqualTo(1));
        Assert.That(Barriers(() => Recorder.CopyBuffer(b, 0, unrelated, 0, 4)), Is.Zero);
    }

    [Test]
    public void DispatchesThatShareBuffersTakeTheLighterBarrier()
    {
        Fill(a, 1);
        Reverse(b, a); // SetUp's fill is a copy: this one is for all stages
        long before = Recorder.ComputeBarrierCount;
        Assert.That(Barriers(() => Reverse(c, b)), Is.EqualTo(1));
        Assert.That(Barriers(() => Reverse(a, c)), Is.EqualTo(1));
        Assert.That(Recorder.ComputeBarrierCount - before, Is.EqualTo(2));
        Assert.That(Read<uint>(a)[0], Is.EqualTo(Count));
    }

    [Test]
    public void CopiesWaitThoughALighterBarrierCameBetween()
    {
        Fill(a, 1);
        Reverse(b, a);
        Reverse(c, b);
        long before = Recorder.ComputeBarrierCount;
        Assert.That(Barriers(() => Recorder.CopyBuffer(b, 0, unrelated, 0, 4)), Is.EqualTo(1));
        Assert.That(Barriers(() => Recorder.CopyBuffer(c, 0, a, 0, 4)), Is.Zero);
        Assert.That(Barriers(() => Reverse(b, a)), Is.EqualTo(1));
        Assert.That(Recorder.ComputeBarrierCount, Is.EqualTo(before), "a dispatch behind a copy waits for all stages");
        Assert.That(Read<uint>(unrelated)[0], Is.EqualTo(Count));
    }

    [Test]
    public void PingPongGivesTheSameAsTheProcessor()
    {
        uint[] expected = Enumerable.Range(0, (int)Count).Select(i => (uint)i).ToArray();
        Fill(a, 0);
        for (uint step = 1; step <= 50; step++)
        {
            Reverse(b, a, step);
            Recorder.CopyBuffer(b, 0, a, 0, a.Size);
            expected = expected.Reverse().Select(value => value + step).ToArray();
        }

        Assert.That(Read<uint>(a), Is.EqualTo(expected));
    }

    [Test]
    public void UpdatesKeepTheirPlaceInTheOrder()
    {
        for (uint step = 1; step <= 20; step++)
        {
            Recorder.UpdateBuffer(a, 0, BitConverter.GetBytes(step));
            Add(b, a);
        }

        Assert.That(Read<uint>(b)[0], Is.EqualTo(210u));
    }

    [Test]
    public void FillsAndCopiesKeepTheirPlaceInTheOrder()
    {
        Recorder.FillBuffer(a, 0, a.Size, 3);
        Recorder.CopyBuffer(a, 0, b, 0, a.Size);
        Recorder.FillBuffer(a, 0, a.Size, 4);
        Recorder.CopyBuffer(b, 0, c, 0, a.Size);
        Recorder.FillBuffer(b, 0, a.Size, 5);

        Assert.That(Read<uint>(a), Is.All.EqualTo(4u));
        Assert.That(Read<uint>(b), Is.All.EqualTo(5u));
        Assert.That(Read<uint>(c), Is.All.EqualTo(3u));
    }

    private long Barriers(Action record)
    {
        long before = Recorder.BarrierCount;
        record();
        return Recorder.BarrierCount - before;
    }

    private void Fill(GpuBuffer target, uint value) =>
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(Count, value, target), Kernels.Groups(Count), 1, 1);

    private void Reverse(GpuBuffer target, GpuBuffer source, uint value = 0) =>
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Reverse), Kernels.Bind(Count, value, target, source), Kernels.Groups(Count), 1, 1);

    private void Add(GpuBuffer target, GpuBuffer source) =>
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Add), Kernels.Bind(Count, 0, target, source), Kernels.Groups(Count), 1, 1);
}
