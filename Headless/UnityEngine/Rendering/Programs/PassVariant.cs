using System.Collections.Generic;
using System.Linq;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>The compiled stages of a pass for one keyword set.</summary>
internal sealed class PassVariant(IReadOnlyList<ShaderBinary> stages)
{
    public IReadOnlyList<ShaderBinary> Stages { get; } = stages;
    public BindingTable[] Tables { get; } = [.. stages.Select(s => new BindingTable(s))];
    public IReadOnlyList<VertexInput> Inputs { get; } = stages[0].Inputs;

    /// <summary>Filled anew for every draw.</summary>
    public ResourceBindings Bindings { get; } = new();

    public string Hash { get; } = string.Join('|', stages.Select(s => s.Hash));
}
