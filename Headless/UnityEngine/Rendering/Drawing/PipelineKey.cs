using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>What decides a draw's pipeline besides its pass variant, for a look-up without building the full description.</summary>
internal readonly record struct PipelineKey(
    PassVariant Variant, PassState State, GpuTopology Topology, string VertexLayout, bool FrontClockwise,
    GpuFormat Color0, GpuFormat Color1, int ColorCount, GpuFormat Depth, int Samples);
