using System.Collections.Generic;
using System.Linq;
using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>What a compiled stage reads, by property number: worked out once, used by every dispatch and draw.</summary>
internal sealed class BindingTable
{
    public BindingTable(ShaderBinary binary)
    {
        Set = binary.DescriptorSet;
        Buffers = [.. Of(binary, k => k is ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer
                or ResourceKind.ByteAddressBuffer or ResourceKind.RWByteAddressBuffer or ResourceKind.Counter)
            .Select(Buffer)];
        Textures = [.. Of(binary, k => k is ResourceKind.Texture or ResourceKind.RWTexture)
            .Select(r => new TextureEntry(ShaderNames.Id(r.Name), r.Name, r.Binding, r.Kind == ResourceKind.RWTexture, r.Dimension, r.Register))];
        Samplers = [.. Of(binary, k => k is ResourceKind.Sampler)
            .Select(r => SamplerEntry.Parse(r.Name, r.Binding, r.Comparison))];
        Blocks = [.. Of(binary, k => k is ResourceKind.ConstantBuffer).Select(r => new BlockEntry(r))];
        HasStorageTextures = Textures.Any(t => t.Storage);
    }

    public int Set { get; }
    public BufferEntry[] Buffers { get; }
    public TextureEntry[] Textures { get; }
    public SamplerEntry[] Samplers { get; }
    public BlockEntry[] Blocks { get; }
    public bool HasStorageTextures { get; }

    private static BufferEntry Buffer(ShaderResource resource)
    {
        bool counter = resource.Kind == ResourceKind.Counter;
        string name = counter ? resource.Name[..resource.Name.IndexOf('@')] : resource.Name;
        return new BufferEntry(ShaderNames.Id(name), name, resource.Binding, resource.Kind, resource.Stride, resource.Register);
    }

    private static IEnumerable<ShaderResource> Of(ShaderBinary binary, Func<ResourceKind, bool> requested) =>
        binary.Resources.Where(r => requested(r.Kind));
}
