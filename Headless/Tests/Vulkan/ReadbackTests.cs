using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class ReadbackTests : DeviceFixture
{
    [Test]
    public void TicketsHoldWhatTheBufferWasWhenAsked()
    {
        using GpuBuffer buffer = StorageBuffer(4);
        Recorder.FillBuffer(buffer, 0, 4, 1);
        ReadbackTicket first = Device.RequestRead(buffer, 0, 4);
        Recorder.FillBuffer(buffer, 0, 4, 2);
        ReadbackTicket second = Device.RequestRead(buffer, 0, 4);
        Recorder.FillBuffer(buffer, 0, 4, 3);

        Assert.That(first.IsDone, Is.False, "nothing was submitted yet");
        Assert.That(() => first.Data.Length, Throws.InvalidOperationException);
        Assert.That(BitConverter.ToUInt32(second.Wait()), Is.EqualTo(2u));
        Assert.That(first.IsDone, Is.True);
        Assert.That(BitConverter.ToUInt32(first.Data), Is.EqualTo(1u));
    }

    [Test]
    public void ASubmittedTicketCompletesByItself()
    {
        using GpuBuffer buffer = StorageBuffer<uint>([42]);
        ReadbackTicket ticket = Device.RequestRead(buffer, 0, 4);
        ulong submission = Recorder.Submit();
        Assert.That(() => ticket.IsDone, Is.True.After(5000, 1));
        Assert.That(Device.IsComplete(submission), Is.True);
        Assert.That(BitConverter.ToUInt32(ticket.Data), Is.EqualTo(42u));
    }

    [Test]
    public void TheProcessorMayRunAhead()
    {
        using GpuBuffer buffer = StorageBuffer(4);
        List<ReadbackTicket> tickets = [];
        for (uint i = 0; i < 20; i++)
        {
            Recorder.FillBuffer(buffer, 0, 4, i);
            tickets.Add(Device.RequestRead(buffer, 0, 4));
            Recorder.Submit();
        }

        Assert.That(tickets.Select(ticket => BitConverter.ToUInt32(ticket.Wait())), Is.EqualTo(Enumerable.Range(0, 20).Select(i => (uint)i)));
    }

    [Test]
    public void LargeBuffersComeBackWhole()
    {
        const int Size = 48 << 20;
        using GpuBuffer buffer = StorageBuffer(Size);
        byte[] data = new byte[Size];
        new Random(3).NextBytes(data);
        Recorder.UpdateBuffer(buffer, 0, data);
        Assert.That(Device.RequestRead(buffer, 0, Size).Wait().SequenceEqual(data), Is.True);
    }

    [Test]
    public void ResourcesMayBeDisposedBeforeTheirWorkHasRun()
    {
        ReadbackTicket ticket;
        using (GpuBuffer buffer = StorageBuffer<uint>([7]))
        {
            ticket = Device.RequestRead(buffer, 0, 4);
        }

        Assert.That(BitConverter.ToUInt32(ticket.Wait()), Is.EqualTo(7u));
    }
}
