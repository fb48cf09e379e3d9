using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>This layer's states as Vulkan's.</summary>
internal static class VulkanStates
{
    public static VkCompareOp Compare(GpuCompare compare) => (VkCompareOp)compare;

    public static VkCullModeFlags Cull(GpuCull cull) => cull switch
    {
        GpuCull.Front => VkCullModeFlags.Front,
        GpuCull.Back => VkCullModeFlags.Back,
        _ => VkCullModeFlags.None,
    };

    public static VkBlendOp Operation(GpuBlendOperation operation) => (VkBlendOp)operation;

    public static VkBlendFactor Factor(GpuBlend blend) => blend switch
    {
        GpuBlend.Zero => VkBlendFactor.Zero,
        GpuBlend.One => VkBlendFactor.One,
        GpuBlend.DstColor => VkBlendFactor.DstColor,
        GpuBlend.SrcColor => VkBlendFactor.SrcColor,
        GpuBlend.OneMinusDstColor => VkBlendFactor.OneMinusDstColor,
        GpuBlend.SrcAlpha => VkBlendFactor.SrcAlpha,
        GpuBlend.OneMinusSrcColor => VkBlendFactor.OneMinusSrcColor,
        GpuBlend.DstAlpha => VkBlendFactor.DstAlpha,
        GpuBlend.OneMinusDstAlpha => VkBlendFactor.OneMinusDstAlpha,
        GpuBlend.SrcAlphaSaturate => VkBlendFactor.SrcAlphaSaturate,
        GpuBlend.OneMinusSrcAlpha => VkBlendFactor.OneMinusSrcAlpha,
        _ => throw new ArgumentOutOfRangeException(nameof(blend), blend, "Unknown blend factor."),
    };

    public static VkPrimitiveTopology Topology(GpuTopology topology) => topology switch
    {
        GpuTopology.TriangleStrip => VkPrimitiveTopology.TriangleStrip,
        GpuTopology.Lines => VkPrimitiveTopology.LineList,
        GpuTopology.LineStrip => VkPrimitiveTopology.LineStrip,
        GpuTopology.Points => VkPrimitiveTopology.PointList,
        _ => VkPrimitiveTopology.TriangleList,
    };

    public static VkFormat Vertex(GpuVertexFormat format) => format switch
    {
        GpuVertexFormat.Float1 => VkFormat.R32Sfloat,
        GpuVertexFormat.Float2 => VkFormat.R32g32Sfloat,
        GpuVertexFormat.Float3 => VkFormat.R32g32b32Sfloat,
        GpuVertexFormat.Float4 => VkFormat.R32g32b32a32Sfloat,
        GpuVertexFormat.Half2 => VkFormat.R16g16Sfloat,
        GpuVertexFormat.Half4 => VkFormat.R16g16b16a16Sfloat,
        GpuVertexFormat.UNorm8x4 => VkFormat.R8g8b8a8Unorm,
        GpuVertexFormat.UInt1 => VkFormat.R32Uint,
        GpuVertexFormat.UInt2 => VkFormat.R32g32Uint,
        GpuVertexFormat.UInt3 => VkFormat.R32g32b32Uint,
        GpuVertexFormat.UInt4 => VkFormat.R32g32b32a32Uint,
        _ => throw new ArgumentOutOfRangeException(nameof(format), format, "Unknown vertex format."),
    };

    public static VkPipelineColorBlendAttachmentState Blend(BlendState blend) => new()
    {
        blendEnable = blend.IsOpaque ? 0u : 1u,
        srcColorBlendFactor = Factor(blend.SourceColor),
        dstColorBlendFactor = Factor(blend.TargetColor),
        colorBlendOp = Operation(blend.ColorOperation),
        srcAlphaBlendFactor = Factor(blend.SourceAlpha),
        dstAlphaBlendFactor = Factor(blend.TargetAlpha),
        alphaBlendOp = Operation(blend.AlphaOperation),
        colorWriteMask = (VkColorComponentFlags)blend.WriteMask,
    };
}
