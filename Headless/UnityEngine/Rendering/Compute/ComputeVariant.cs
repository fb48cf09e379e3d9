using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>A compiled kernel variant with its binding table; pipelines are made at the first dispatch.</summary>
internal sealed class ComputeVariant
{
    private readonly Dictionary<string, GpuComputePipeline> pipelinesByFormat = new(StringComparer.Ordinal);
    private readonly ComputeBlock[] blocks;
    private GpuComputePipeline? pipeline;

    /// <param name="label">"path of the shader|kernel|keywords".</param>
    public ComputeVariant(ShaderBinary binary, ComputeState state, string label)
    {
        Label = label;
        Binary = binary;
        Table = new BindingTable(binary);
        blocks = [.. Table.Blocks.Select(b => new ComputeBlock(b, state))];
        Unsupported = DeviceRequirements.WhyUnsupported(binary);
    }

    public string Label { get; }
    public ShaderBinary Binary { get; }
    public BindingTable Table { get; }

    /// <summary>The limit of the device that the kernel exceeds; null when it runs.</summary>
    public string? Unsupported { get; }

    public ReadOnlySpan<ComputeBlock> Blocks => blocks;
    public ResourceBindings Bindings { get; } = new();

    public GpuComputePipeline Pipeline(ReadOnlySpan<(int Binding, ImageFormat Format)> storageFormats)
    {
        if (storageFormats.IsEmpty)
        {
            return pipeline ??= Create(Binary);
        }

        var formats = new Dictionary<int, ImageFormat>();
        string key = string.Empty;
        foreach ((int binding, ImageFormat format) in storageFormats)
        {
            formats[binding] = format;
            key += $"{binding}:{format};";
        }

        if (!pipelinesByFormat.TryGetValue(key, out GpuComputePipeline? found))
        {
            found = Create(ImageFormats.With(Binary, formats));
            pipelinesByFormat.Add(key, found);
        }

        return found;
    }

    private GpuComputePipeline Create(ShaderBinary binary)
    {
        ExecutedKernels.Add(Binary);
        return GraphicsDevice.Device.GetComputePipeline(binary);
    }
}
