using System.Collections.Generic;
using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>One kernel of a compute shader: what is bound to it and its compiled variants.</summary>
internal sealed class ComputeKernel(KernelDeclaration declaration)
{
    private readonly Dictionary<string, ComputeVariant?> variants = new(StringComparer.Ordinal);

    public string Name => declaration.Name;
    public Dictionary<int, BufferSlot> Buffers { get; } = [];
    public Dictionary<int, TextureSlot> Textures { get; } = [];

    /// <summary>Property numbers of textures taken from the globals under another name.</summary>
    public Dictionary<int, int> GlobalTextures { get; } = [];

    public bool TryGet(string key, out ComputeVariant? variant) => variants.TryGetValue(key, out variant);

    public void Add(string key, ComputeVariant? variant) => variants.Add(key, variant);
}
