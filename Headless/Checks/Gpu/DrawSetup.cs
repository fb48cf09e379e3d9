using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Checks.Gpu;

/// <summary>The state that a pass is compiled with: one colour target of 16-bit floats and a depth target.</summary>
internal static class DrawSetup
{
    private const int Stride = 16;

    public static RenderPipelineDescription For(IReadOnlyList<ShaderBinary> stages, string name) => new()
    {
        Stages = stages,
        Name = name,
        Topology = stages.Select(s => s.InputPrimitive).FirstOrDefault(p => p.Length > 0) switch
        {
            "point" => GpuTopology.Points,
            "line" => GpuTopology.Lines,
            _ => GpuTopology.Triangles,
        },
        Streams = [.. stages[0].Inputs.Select(input => new VertexStream(input.Location, Stride))],
        Attributes = [.. stages[0].Inputs.Select(input => new VertexAttribute(input.Location, Format(input), 0, input.Location))],
        ColorFormats = [GpuFormat.R16G16B16A16Float],
        DepthFormat = GpuFormat.D32Float,
    };

    private static GpuVertexFormat Format(VertexInput input) =>
        (input.Integer ? GpuVertexFormat.UInt1 : GpuVertexFormat.Float1) + (input.Components - 1);
}
