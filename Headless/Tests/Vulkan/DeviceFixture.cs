using NUnit.Framework;
using System.Runtime.InteropServices;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

/// <summary>A device under the validation layer; every test fails on any of its messages.</summary>
public abstract class DeviceFixture
{
    private int messagesBefore;

    protected GpuDevice Device { get; private set; } = null!;

    protected CommandRecorder Recorder => Device.Recorder;

    [OneTimeSetUp]
    public void OpenDevice() =>
        Device = GpuDevice.Create(new GpuDeviceOptions
        {
            Adapter = Environment.GetEnvironmentVariable("VULKAN_TEST_DEVICE"),
            Validate = true,
            ValidateSynchronization = true,
        });

    [OneTimeTearDown]
    public void CloseDevice()
    {
        Device.Dispose();
        Assert.That(Device.ValidationMessages.Skip(messagesBefore), Is.Empty);
    }

    [SetUp]
    public void CountMessages() => messagesBefore = Device.ValidationMessages.Count;

    [TearDown]
    public void ExpectNoMessages()
    {
        Device.WaitIdle();
        string[] messages = Device.ValidationMessages.Skip(messagesBefore).ToArray();
        messagesBefore += messages.Length;
        Assert.That(messages, Is.Empty);
    }

    protected GpuBuffer StorageBuffer(long size, string name = "buffer") => Device.CreateBuffer(size, BufferUse.Storage, name);

    protected GpuBuffer StorageBuffer<T>(ReadOnlySpan<T> data, BufferUse use = BufferUse.Storage, string name = "data")
        where T : unmanaged
    {
        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(data);
        GpuBuffer buffer = Device.CreateBuffer(bytes.Length, use, name);
        Recorder.UpdateBuffer(buffer, 0, bytes);
        return buffer;
    }

    protected T[] Read<T>(GpuBuffer buffer)
        where T : unmanaged
    {
        T[] data = new T[buffer.Size / Marshal.SizeOf<T>()];
        Device.ReadBuffer(buffer, 0, MemoryMarshal.AsBytes(data.AsSpan()));
        return data;
    }
}
