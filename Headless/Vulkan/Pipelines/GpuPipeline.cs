using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A pipeline with its layout; created and owned by the device.</summary>
public abstract class GpuPipeline
{
    private protected GpuPipeline(string name) => Name = name;

    /// <summary>Name in errors and captures.</summary>
    public string Name { get; }

    internal VkPipeline Handle { get; private protected init; }

    internal VkPipelineLayout Layout { get; private protected init; }

    internal StageLayout[] Stages { get; private protected init; } = [];

    internal abstract VkPipelineBindPoint BindPoint { get; }

    internal unsafe void Destroy(DeviceContext context)
    {
        Vk.vkDestroyPipeline(context.Handle, Handle, null);
        Vk.vkDestroyPipelineLayout(context.Handle, Layout, null);
        foreach (StageLayout stage in Stages)
        {
            stage.Dispose();
        }
    }
}
