using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A graphics pipeline ready to draw with; made for the target formats of its description.</summary>
public sealed class GpuRenderPipeline : GpuPipeline
{
    internal GpuRenderPipeline(RenderPipelineDescription description, StageLayout[] stages, VkPipelineLayout layout, VkPipeline handle)
        : base(RenderPipelineKey.NameOf(description))
    {
        Description = description;
        Stages = stages;
        Layout = layout;
        Handle = handle;
    }

    /// <summary>What it was made from.</summary>
    public RenderPipelineDescription Description { get; }

    internal override VkPipelineBindPoint BindPoint => VkPipelineBindPoint.Graphics;
}
