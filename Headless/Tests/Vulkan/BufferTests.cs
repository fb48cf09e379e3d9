using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class BufferTests : DeviceFixture
{
    [TestCase(1)]
    [TestCase(4099)]
    [TestCase(3 << 20)]
    public void NewBuffersAreZeroEvenInUsedMemory(int size)
    {
        using (GpuBuffer dirty = StorageBuffer(size))
        {
            Recorder.FillBuffer(dirty, 0, size & ~3, 0xdeadbeef);
        }

        Device.WaitIdle();
        using GpuBuffer fresh = StorageBuffer(size);
        Assert.That(Read<byte>(fresh), Is.All.Zero);
    }

    [TestCase(0, 1)]
    [TestCase(3, 17)]
    [TestCase(1000, 0)]
    public void UpdatesChangeOnlyTheirBytes(int offset, int count)
    {
        using GpuBuffer buffer = StorageBuffer(1021);
        byte[] data = Enumerable.Range(1, count).Select(i => (byte)i).ToArray();
        Recorder.UpdateBuffer(buffer, offset, data);
        byte[] expected = new byte[1021];
        data.CopyTo(expected, offset);
        Assert.That(Read<byte>(buffer), Is.EqualTo(expected));
    }

    [Test]
    public void ManyBuffersShareFewAllocationsAndGiveThemBack()
    {
        long before = Device.AllocatedBytes;
        for (int round = 0; round < 3; round++)
        {
            GpuBuffer[] buffers = Enumerable.Range(1, 300).Select(i => StorageBuffer(i * 1000, $"buffer {i}")).ToArray();
            Assert.That(Device.AllocatedBytes - before, Is.GreaterThanOrEqualTo(buffers.Sum(buffer => buffer.Size)));
            foreach (GpuBuffer buffer in buffers)
            {
                buffer.Dispose();
            }
        }

        Assert.That(Device.AllocatedBytes, Is.EqualTo(before));
    }

    [Test]
    public void ABufferThatNoShaderCanSeeIsNamed() =>
        Assert.That(
            () => StorageBuffer(Device.Limits.MaxStorageBufferRange + 4, "particles"),
            Throws.TypeOf<GpuException>().With.Message.Contains("'particles'").And.Message.Contains("MaxStorageBufferRange"));

    [TestCase(0)]
    [TestCase(-4)]
    public void ABufferWithoutBytesIsNamed(int size) =>
        Assert.That(() => StorageBuffer(size, "empty"), Throws.TypeOf<GpuException>().With.Message.Contains("'empty'"));

    [Test]
    public void RangesOutsideAreNamed()
    {
        using GpuBuffer buffer = StorageBuffer(16, "small");
        using GpuBuffer other = StorageBuffer(16);
        Assert.That(() => Recorder.UpdateBuffer(buffer, 8, new byte[9]), Throws.TypeOf<GpuException>().With.Message.Contains("'small'"));
        Assert.That(() => Recorder.CopyBuffer(buffer, 4, other, 0, 16), Throws.TypeOf<GpuException>().With.Message.Contains("'small'"));
        Assert.That(() => Device.RequestRead(buffer, 16, 1), Throws.TypeOf<GpuException>().With.Message.Contains("'small'"));
        Assert.That(() => Recorder.FillBuffer(buffer, 2, 4, 0), Throws.TypeOf<GpuException>().With.Message.Contains("'small'"));
    }

    [Test]
    public void WrongUseIsNamed()
    {
        using GpuBuffer vertices = Device.CreateBuffer(16, BufferUse.Vertex, "vertices");
        Assert.That(
            () => Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(1, 0, vertices), 1, 1, 1),
            Throws.TypeOf<GpuException>().With.Message.Contains("'vertices'").And.Message.Contains("Storage"));
    }

    [Test]
    public void ReadsOutOfBoundsGiveZeroAndWritesAreDropped()
    {
        using GpuBuffer target = StorageBuffer(64 * 4);
        using GpuBuffer source = StorageBuffer<uint>([11, 12]);
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Add), Kernels.Bind(200, 0, target, source), 4, 1, 1);
        Assert.That(Read<uint>(target), Is.EqualTo(new uint[] { 11, 12 }.Concat(Enumerable.Repeat(0u, 62))));
    }
}
