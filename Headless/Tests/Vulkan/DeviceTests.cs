using NUnit.Framework;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

public sealed class DeviceTests
{
    [Test]
    public void ListedDevicesHaveNamesAndKinds()
    {
        IReadOnlyList<AdapterInfo> adapters = GpuDevice.Enumerate();
        Assert.That(adapters, Is.Not.Empty);
        Assert.That(adapters.Select(adapter => adapter.Index), Is.EqualTo(Enumerable.Range(0, adapters.Count)));
        Assert.That(adapters.Select(adapter => adapter.Name), Is.All.Not.Empty);
        Assert.That(adapters.Select(adapter => adapter.Type), Is.SubsetOf(new[] { "DiscreteGpu", "IntegratedGpu", "VirtualGpu", "Cpu", "Other" }));
    }

    [Test]
    public void ADeviceIsChosenByIndexOrNamePart()
    {
        AdapterInfo last = GpuDevice.Enumerate()[^1];
        using GpuDevice byIndex = GpuDevice.Create(new GpuDeviceOptions { Adapter = $"{last.Index}" });
        using GpuDevice byName = GpuDevice.Create(new GpuDeviceOptions { Adapter = last.Name[..4].ToUpperInvariant() });
        Assert.That(byIndex.Adapter, Is.EqualTo(last));
        Assert.That(byName.Adapter.Name, Does.StartWith(last.Name[..4]));
    }

    [Test]
    public void AnUnknownDeviceIsAnsweredWithTheList()
    {
        string known = GpuDevice.Enumerate()[0].Name;
        Assert.That(
            () => GpuDevice.Create(new GpuDeviceOptions { Adapter = "no such device" }),
            Throws.TypeOf<UnknownAdapterException>().With.Message.Contains("no such device").And.Message.Contains(known));
    }

    [Test]
    public void AGpuIsPreferredToAProcessor()
    {
        using GpuDevice device = GpuDevice.Create(new GpuDeviceOptions());
        bool hasGpu = GpuDevice.Enumerate().Any(adapter => adapter.Type is "DiscreteGpu" or "IntegratedGpu");
        Assert.That(device.Adapter.Type, hasGpu ? Does.EndWith("Gpu") : Is.Not.Empty);
    }

    [Test]
    public void TheValidationLayerIsHeard()
    {
        using GpuDevice device = GpuDevice.Create(new GpuDeviceOptions { Validate = true });
        Assert.That(device.ValidationMessages, Is.Empty);
        using GpuBuffer constants = device.CreateBuffer(64, BufferUse.Uniform, "misaligned");
        using GpuBuffer target = device.CreateBuffer(4, BufferUse.Storage, "target");
        ResourceBindings bindings = new();
        bindings.SetBuffer(0, 0, constants, 4);
        bindings.SetBuffer(0, 1, target);
        device.Recorder.Dispatch(device.GetComputePipeline(Kernels.Fill), bindings, 1, 1, 1);
        device.WaitIdle();
        Assert.That(device.ValidationMessages, Has.Some.Contains("dynamicOffset").IgnoreCase);
    }

    [Test]
    public void ResourcesLeftAliveAreFreedWithTheDevice()
    {
        GpuDevice device = GpuDevice.Create(new GpuDeviceOptions { Validate = true });
        device.CreateBuffer(64, BufferUse.Storage, "left");
        device.CreateTexture(new GpuTextureDescription { Width = 4, Height = 4, Format = GpuFormat.R8Unorm }, "left too");
        device.Dispose();
        Assert.That(device.ValidationMessages, Is.Empty);
    }

    [Test]
    public void ThePipelineCacheIsWrittenToItsFolder()
    {
        string folder = Directory.CreateTempSubdirectory("pipeline-cache").FullName;
        try
        {
            for (int run = 0; run < 2; run++)
            {
                using GpuDevice device = GpuDevice.Create(new GpuDeviceOptions { CacheDirectory = folder });
                device.GetComputePipeline(Kernels.Fill);
            }

            Assert.That(Directory.GetFiles(folder, "pipelines-*.bin"), Has.Length.EqualTo(1));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
