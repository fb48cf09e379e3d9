using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>An open Vulkan device: creates resources and pipelines, records and runs work. One thread at a time.</summary>
public sealed class GpuDevice : IDisposable
{
    private readonly DeviceContext context;
    private readonly PipelineLibrary pipelines;
    private readonly SamplerCache samplers;
    private readonly SubmissionRing ring;
    private readonly CommandStream stream;
    private readonly TimerCommands timers;
    private readonly Readback readback;
    private bool disposed;

    private GpuDevice(DeviceContext context, GpuDeviceOptions options)
    {
        this.context = context;
        pipelines = new PipelineLibrary(context, options.CacheDirectory);
        samplers = new SamplerCache(context);
        ring = new SubmissionRing(context);
        stream = new CommandStream(context, ring, pipelines);
        timers = new TimerCommands(stream);
        readback = new Readback(stream);
        Recorder = new CommandRecorder(stream, timers);
        if (options.CheckBounds)
        {
            context.Bounds = new BoundsLog(context, ring);
            Recorder.FillBuffer(context.Bounds.Buffer, 0, context.Bounds.Buffer.PaddedSize, 0);
        }
    }

    /// <summary>The device in use.</summary>
    public AdapterInfo Adapter => context.Adapter;

    /// <summary>What it can do.</summary>
    public GpuLimits Limits => context.Limits;

    /// <summary>Bytes of all live buffers and textures, as the driver sizes them.</summary>
    public long AllocatedBytes => context.Memory.AllocatedBytes;

    /// <summary>Warnings and errors of the validation layer since the device was opened; empty without it.</summary>
    public IReadOnlyList<string> ValidationMessages => context.Instance.Messages;

    /// <summary>Whether new buffers, textures and groupshared memory hold set bits in place of zeros.</summary>
    public bool Poisons => context.Poisons;

    /// <summary>Records work.</summary>
    public CommandRecorder Recorder { get; }

    /// <summary>All Vulkan devices of this machine.</summary>
    /// <exception cref="GpuException">There is no Vulkan loader or no driver; the message says what to install.</exception>
    public static IReadOnlyList<AdapterInfo> Enumerate()
    {
        using VulkanInstance instance = new(validate: false, synchronization: false);
        return AdapterList.Read(instance).Select(adapter => adapter.Info).ToList();
    }

    /// <summary>Opens a device.</summary>
    /// <exception cref="GpuException">No device fits; the message lists what there is.</exception>
    public static GpuDevice Create(GpuDeviceOptions options)
    {
        DeviceContext context = DeviceContext.Open(options);
        try
        {
            return new GpuDevice(context, options);
        }
        catch
        {
            context.Dispose();
            throw;
        }
    }

    /// <summary>Creates a buffer of zeros, or of set bits on a device that poisons; <paramref name="size"/> in bytes.</summary>
    /// <exception cref="GpuException">Size is not positive or beyond a limit, or memory is out.</exception>
    public GpuBuffer CreateBuffer(long size, BufferUse use, string name)
    {
        GpuBuffer buffer = new(context, ring, size, use, name);
        Recorder.FillBuffer(buffer, 0, buffer.PaddedSize, Poisons ? uint.MaxValue : 0);
        return buffer;
    }

    /// <summary>Creates a texture whose texels are all zero, or poisoned on a device that does so.</summary>
    /// <exception cref="GpuException">A size, format or sample count is not supported, or memory is out.</exception>
    public GpuTexture CreateTexture(GpuTextureDescription description, string name)
    {
        GpuTexture texture = new(context, ring, description, name);
        if (Poisons)
        {
            Recorder.PoisonTexture(texture);
        }
        else
        {
            Recorder.ClearTexture(texture);
        }

        return texture;
    }

    /// <summary>On a device that poisons: makes a texture's content what a new one's is.</summary>
    public void Poison(GpuTexture texture)
    {
        if (Poisons)
        {
            Recorder.PoisonTexture(texture);
        }
    }

    /// <summary>
    /// The accesses outside buffers and arrays that shaders have made since the last call, a line a shader and variable;
    /// submits and waits. Empty unless <see cref="GpuDeviceOptions.CheckBounds"/>.
    /// </summary>
    public IReadOnlyList<string> TakeOutOfBounds()
    {
        if (context.Bounds is not { } bounds)
        {
            return [];
        }

        uint[] words = new uint[bounds.Used / sizeof(uint)];
        WaitIdle();
        ReadBuffer(bounds.Buffer, 0, System.Runtime.InteropServices.MemoryMarshal.AsBytes(words.AsSpan()));
        IReadOnlyList<string> lines = bounds.Describe(words);
        if (lines.Count > 0)
        {
            Recorder.FillBuffer(bounds.Buffer, 0, bounds.Used, 0);
            WaitIdle();
        }

        return lines;
    }

    /// <summary>The sampler of a description; equal descriptions share one, which lives as long as the device.</summary>
    public GpuSampler CreateSampler(GpuSamplerDescription description) => samplers.Get(description);

    /// <summary>The pipeline of a compute shader; equal shaders share one, which lives as long as the device.</summary>
    /// <exception cref="GpuException">The shader needs more than the device has.</exception>
    public GpuComputePipeline GetComputePipeline(ShaderBinary shader) => pipelines.GetCompute(shader);

    /// <summary>The pipeline of a description; equal descriptions share one, which lives as long as the device.</summary>
    /// <exception cref="GpuException">The stages need more than the device has or do not fit the description.</exception>
    public GpuRenderPipeline GetRenderPipeline(RenderPipelineDescription description) => pipelines.GetRender(description);

    /// <summary>Reads bytes of a buffer after all recorded work; submits and waits.</summary>
    public void ReadBuffer(GpuBuffer buffer, long offset, Span<byte> target) =>
        RequestRead(buffer, offset, target.Length).Wait().CopyTo(target);

    /// <summary>Asks for bytes of a buffer as they are after the work recorded so far; does not wait.</summary>
    public ReadbackTicket RequestRead(GpuBuffer buffer, long offset, int size) => readback.Request(buffer, offset, size);

    /// <summary>Reads one mip level of one layer (all slices of a 3D texture), rows tightly packed; submits and waits.</summary>
    public byte[] ReadTexture(GpuTexture texture, int mipLevel = 0, int layer = 0) =>
        RequestRead(texture, mipLevel, layer).Wait().ToArray();

    /// <summary>Asks for one mip level of one layer as it is after the work recorded so far; does not wait.</summary>
    public ReadbackTicket RequestRead(GpuTexture texture, int mipLevel = 0, int layer = 0) =>
        readback.Request(texture, mipLevel, layer);

    /// <summary>Timer scopes finished since the last call, in the order they were begun. Does not wait.</summary>
    public IReadOnlyList<TimerResult> CollectTimers()
    {
        ring.Poll();
        return timers.Collect();
    }

    /// <summary>Whether the work of a ticket of <see cref="CommandRecorder.Submit"/> has run.</summary>
    public bool IsComplete(ulong ticket)
    {
        ring.Poll();
        return ring.Completed >= ticket;
    }

    /// <summary>Waits for the work of a ticket.</summary>
    public void Wait(ulong ticket) => ring.Wait(ticket);

    /// <summary>Submits what is recorded without waiting.</summary>
    public void Flush() => stream.Submit();

    /// <summary>Submits what is recorded and waits for all of it.</summary>
    public void WaitIdle() => ring.Wait(stream.Submit());

    /// <summary>Finishes all work and closes the device; resources that are still alive are freed with it.</summary>
    public void Dispose()
    {
        if (disposed)
        {
            return;
        }

        disposed = true;
        foreach (GpuResource resource in context.Resources.ToArray())
        {
            resource.Dispose();
        }

        ring.Dispose();
        samplers.Dispose();
        pipelines.Dispose();
        context.Dispose();
    }
}
