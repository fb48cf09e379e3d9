using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>A driver's compiler alone: it makes programs of shaders and reports on them, and runs none. A driver without hardware will do.</summary>
public sealed class GpuCompiler : IDisposable
{
    private readonly DeviceContext context;
    private readonly PipelineLibrary pipelines;
    private readonly ExecutableReader reader;

    private GpuCompiler(DeviceContext context, string cacheDirectory)
    {
        this.context = context;
        pipelines = new PipelineLibrary(context, cacheDirectory);
        reader = new ExecutableReader(context);
    }

    /// <summary>The device that is compiled for.</summary>
    public AdapterInfo Adapter => context.Adapter;

    /// <summary>Opens the compiler of a device.</summary>
    /// <param name="cacheDirectory">Folder for the driver's pipeline cache.</param>
    /// <exception cref="GpuException">No device fits, or its driver does not report compiled programs.</exception>
    public static GpuCompiler Create(string? adapter, string cacheDirectory)
    {
        DeviceContext context = DeviceContext.Open(new GpuDeviceOptions { Adapter = adapter }, captureExecutables: true);
        try
        {
            return new GpuCompiler(context, cacheDirectory);
        }
        catch
        {
            context.Dispose();
            throw;
        }
    }

    /// <summary>Compiles a kernel.</summary>
    /// <exception cref="GpuException">The shader needs more than the device has, or the driver's compiler failed.</exception>
    public IReadOnlyList<GpuExecutable> Compile(ShaderBinary shader) => reader.Read(pipelines.GetCompute(shader));

    /// <summary>Compiles the stages of a draw call.</summary>
    /// <exception cref="GpuException">The stages need more than the device has, do not fit the description, or the compiler failed.</exception>
    public IReadOnlyList<GpuExecutable> Compile(RenderPipelineDescription description) => reader.Read(pipelines.GetRender(description));

    /// <summary>Closes the device.</summary>
    public void Dispose()
    {
        pipelines.Dispose();
        context.Dispose();
    }
}
