using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>All pipelines of a device, one for each content.</summary>
internal sealed class PipelineLibrary : IDisposable
{
    private readonly DeviceContext context;
    private readonly PipelineCacheFile file;
    private readonly RenderPipelineBuilder builder;
    private readonly Dictionary<string, GpuComputePipeline> compute = [];
    private readonly Dictionary<string, GpuRenderPipeline> render = [];
    private readonly Dictionary<string, GpuComputePipeline> variants = [];

    public PipelineLibrary(DeviceContext context, string? directory)
    {
        this.context = context;
        file = new PipelineCacheFile(context, directory);
        builder = new RenderPipelineBuilder(context, file.Handle);
    }

    public GpuComputePipeline GetCompute(ShaderBinary shader)
    {
        string key = $"{shader.Hash} {shader.EntryPoint}";
        if (!compute.TryGetValue(key, out GpuComputePipeline? pipeline))
        {
            compute[key] = pipeline = new GpuComputePipeline(context, file.Handle, shader);
        }

        return pipeline;
    }

    public GpuRenderPipeline GetRender(RenderPipelineDescription description)
    {
        string key = RenderPipelineKey.Of(description);
        if (!render.TryGetValue(key, out GpuRenderPipeline? pipeline))
        {
            render[key] = pipeline = builder.Build(description);
        }

        return pipeline;
    }

    /// <summary>The kernel for the formats of the RW textures that are bound: SPIR-V names a format, HLSL does not.</summary>
    public GpuComputePipeline FitImageFormats(GpuComputePipeline pipeline, ResourceBindings bindings)
    {
        Dictionary<int, ImageFormat>? formats = null;
        foreach (LayoutEntry entry in pipeline.Stages[0].Entries)
        {
            if (bindings.Slot(0, entry.Binding).Resource is GpuTexture texture && !entry.FitsFormat(texture))
            {
                formats ??= [];
                formats[entry.Binding] = texture.Info.Image;
            }
        }

        if (formats is null)
        {
            return pipeline;
        }

        string key = $"{pipeline.Shader.Hash} {pipeline.Shader.EntryPoint} {string.Join(',', formats)}";
        if (!variants.TryGetValue(key, out GpuComputePipeline? variant))
        {
            ShaderBinary fitted = ImageFormats.With(pipeline.Shader, formats);
            variants[key] = variant = ReferenceEquals(fitted, pipeline.Shader) ? pipeline : GetCompute(fitted);
        }

        return variant;
    }

    public void Dispose()
    {
        foreach (GpuPipeline pipeline in compute.Values)
        {
            pipeline.Destroy(context);
        }

        foreach (GpuPipeline pipeline in render.Values)
        {
            pipeline.Destroy(context);
        }

        file.Dispose();
    }
}
