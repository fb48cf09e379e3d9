using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>Everything that decides a graphics pipeline; equal content gives the same <see cref="GpuRenderPipeline"/>.</summary>
public sealed record RenderPipelineDescription
{
    /// <summary>Vertex, optional geometry and optional fragment stage.</summary>
    public required IReadOnlyList<ShaderBinary> Stages { get; init; }

    /// <summary>Name in errors and captures.</summary>
    public string Name { get; init; } = "";

    /// <summary>Primitive form.</summary>
    public GpuTopology Topology { get; init; }

    /// <summary>Vertex streams; empty when the shader reads buffers by SV_VertexID.</summary>
    public IReadOnlyList<VertexStream> Streams { get; init; } = [];

    /// <summary>Vertex attributes; one for each of the vertex shader's inputs.</summary>
    public IReadOnlyList<VertexAttribute> Attributes { get; init; } = [];

    /// <summary>Formats of the color targets, in order.</summary>
    public IReadOnlyList<GpuFormat> ColorFormats { get; init; } = [];

    /// <summary>Format of the depth target; None without one.</summary>
    public GpuFormat DepthFormat { get; init; }

    /// <summary>Samples of all targets.</summary>
    public int Samples { get; init; } = 1;

    /// <summary>Faces left out.</summary>
    public GpuCull Cull { get; init; } = GpuCull.Back;

    /// <summary>Clockwise triangles on the screen face the viewer (Unity, D3D11).</summary>
    public bool FrontClockwise { get; init; } = true;

    /// <summary>Depth comparison; Always together with no write turns the depth test off.</summary>
    public GpuCompare DepthCompare { get; init; } = GpuCompare.LessEqual;

    /// <summary>Depth is written.</summary>
    public bool DepthWrite { get; init; } = true;

    /// <summary>Depths outside 0 to 1 are clipped; otherwise clamped.</summary>
    public bool DepthClip { get; init; } = true;

    /// <summary>ShaderLab's Offset: slope factor.</summary>
    public float DepthBiasSlope { get; init; }

    /// <summary>ShaderLab's Offset: units.</summary>
    public float DepthBiasUnits { get; init; }

    /// <summary>Blend state of each color target; shorter than the targets repeats the last, empty is opaque.</summary>
    public IReadOnlyList<BlendState> Blend { get; init; } = [];

    /// <summary>Alpha turns into coverage (samples &gt; 1).</summary>
    public bool AlphaToCoverage { get; init; }

    /// <summary>Fill mode lines.</summary>
    public bool Wireframe { get; init; }
}
