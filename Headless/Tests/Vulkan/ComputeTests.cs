using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class ComputeTests : DeviceFixture
{
    [TestCase(1u)]
    [TestCase(63u)]
    [TestCase(64u)]
    [TestCase(65u)]
    [TestCase(913u)]
    [TestCase(100003u)]
    public void FillThenAddGivesTheSum(uint count)
    {
        using GpuBuffer a = StorageBuffer(count * 4);
        using GpuBuffer b = StorageBuffer(count * 4);
        Dispatch(Kernels.Fill, count, Kernels.Bind(count, 5, a));
        Dispatch(Kernels.Fill, count, Kernels.Bind(count, 100, b));
        Dispatch(Kernels.Add, count, Kernels.Bind(count, 7, a, b));

        uint[] result = Read<uint>(a);

        Assert.That(result, Is.EqualTo(Enumerable.Range(0, (int)count).Select(i => (uint)(5 + i + 100 + i + 7))));
    }

    [Test]
    public void IndirectDispatchTakesItsGroupsFromTheDevice()
    {
        const uint Count = 1000;
        using GpuBuffer arguments = Device.CreateBuffer(12, BufferUse.Storage | BufferUse.Indirect, "arguments");
        using GpuBuffer target = StorageBuffer(2 * Count * 4);
        Recorder.Dispatch(Device.GetComputePipeline(Kernels.Arguments), Kernels.Bind(0, Count, arguments), 1, 1, 1);
        Recorder.DispatchIndirect(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(2 * Count, 1, target), arguments, 0);

        uint[] result = Read<uint>(target);

        uint written = (Count + 63) / 64 * 64;
        Assert.That(result, Is.EqualTo(Enumerable.Range(0, (int)(2 * Count)).Select(i => i < written ? (uint)(i + 1) : 0)));
    }

    [Test]
    public void ConstantDataIsTakenWhenTheDispatchIsRecorded()
    {
        using GpuBuffer first = StorageBuffer(4);
        using GpuBuffer second = StorageBuffer(4);
        ResourceBindings bindings = Kernels.Bind(1, 10, first);
        Dispatch(Kernels.Fill, 1, bindings);
        Kernels.SetConstants(bindings, 1, 20);
        bindings.SetBuffer(0, 1, second);
        Dispatch(Kernels.Fill, 1, bindings);

        Assert.That(Read<uint>(first), Is.EqualTo(new uint[] { 10 }));
        Assert.That(Read<uint>(second), Is.EqualTo(new uint[] { 20 }));
    }

    [Test]
    public void ConstantsMayComeFromABuffer()
    {
        using GpuBuffer constants = StorageBuffer<uint>([3, 40, 0, 0], BufferUse.Uniform, "constants");
        using GpuBuffer target = StorageBuffer(12);
        ResourceBindings bindings = new();
        bindings.SetBuffer(0, 0, constants);
        bindings.SetBuffer(0, 1, target);
        Dispatch(Kernels.Fill, 3, bindings);

        Assert.That(Read<uint>(target), Is.EqualTo(new uint[] { 40, 41, 42 }));
    }

    [Test]
    public void ALongRunOfDispatchesSubmitsItselfAndStaysInOrder()
    {
        const uint Count = 64;
        using GpuBuffer a = StorageBuffer(Count * 4);
        using GpuBuffer ones = StorageBuffer<uint>(Enumerable.Repeat(1u, (int)Count).ToArray());
        ResourceBindings bindings = Kernels.Bind(Count, 0, a, ones);
        GpuComputePipeline add = Device.GetComputePipeline(Kernels.Add);
        for (int i = 0; i < 9000; i++)
        {
            Recorder.Dispatch(add, bindings, 1, 1, 1);
        }

        Assert.That(Read<uint>(a), Is.All.EqualTo(9000u));
    }

    [Test]
    public void EqualShadersShareOnePipeline() =>
        Assert.That(Device.GetComputePipeline(Kernels.Fill with { }), Is.SameAs(Device.GetComputePipeline(Kernels.Fill)));

    [Test]
    public void AMissingBufferIsNamed()
    {
        using GpuBuffer target = StorageBuffer(4);
        Assert.That(
            () => Dispatch(Kernels.Add, 1, Kernels.Bind(1, 0, target)),
            Throws.TypeOf<GpuException>().With.Message.Contains("'Add'").And.Message.Contains("'_Source'"));
    }

    [Test]
    public void ADisposedBufferIsNamed()
    {
        GpuBuffer target = StorageBuffer(4, "gone");
        ResourceBindings bindings = Kernels.Bind(1, 0, target);
        target.Dispose();
        Assert.That(() => Dispatch(Kernels.Fill, 1, bindings), Throws.TypeOf<ObjectDisposedException>().With.Message.Contains("'gone'"));
    }

    [Test]
    public void TooManyGroupsAreNamed()
    {
        using GpuBuffer target = StorageBuffer(4);
        uint tooMany = Device.Limits.MaxGroupCount.Y + 1;
        Assert.That(
            () => Recorder.Dispatch(Device.GetComputePipeline(Kernels.Fill), Kernels.Bind(1, 0, target), 1, tooMany, 1),
            Throws.TypeOf<GpuException>().With.Message.Contains("Fill").And.Message.Contains($"{tooMany}"));
    }

    [Test]
    public void TooManyThreadsInAGroupAreNamed() =>
        Assert.That(
            () => Device.GetComputePipeline(Kernels.Fill with { GroupX = 1 << 20, Hash = "too big" }),
            Throws.TypeOf<GpuException>().With.Message.Contains("threads"));

    private void Dispatch(Headless.Shaders.ShaderBinary kernel, uint count, ResourceBindings bindings) =>
        Recorder.Dispatch(Device.GetComputePipeline(kernel), bindings, Kernels.Groups(count), 1, 1);
}
