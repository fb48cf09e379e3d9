using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>The descriptor set of one shader stage: its bindings in order.</summary>
internal sealed unsafe class StageLayout : IDisposable
{
    private readonly DeviceContext context;

    public StageLayout(DeviceContext context, ShaderBinary? shader, string name)
    {
        this.context = context;
        Entries = shader is null ? [] : shader.Resources.OrderBy(resource => resource.Binding).Select(resource => LayoutEntry.From(resource, name)).ToArray();
        UniformCount = Entries.Count(entry => entry.Type == VkDescriptorType.UniformBufferDynamic);
        HasStorageImages = Entries.Any(entry => entry.Type == VkDescriptorType.StorageImage);
        Stages = StageMask(shader?.Stage);
        if (shader is not null)
        {
            CheckLimits(context, name);
        }

        VkDescriptorSetLayoutBinding[] bindings = new VkDescriptorSetLayoutBinding[Entries.Length];
        for (int i = 0; i < bindings.Length; i++)
        {
            bindings[i] = new VkDescriptorSetLayoutBinding
            {
                binding = (uint)Entries[i].Binding,
                descriptorType = Entries[i].Type,
                descriptorCount = 1,
                stageFlags = ShaderStages.Flag(shader!.Stage),
            };
        }

        fixed (VkDescriptorSetLayoutBinding* first = bindings)
        {
            VkDescriptorSetLayoutCreateInfo info = new() { bindingCount = (uint)bindings.Length, pBindings = first };
            VkDescriptorSetLayout handle;
            Vk.vkCreateDescriptorSetLayout(context.Handle, &info, null, &handle).Check($"Creating the layout of '{name}'");
            Handle = handle;
        }
    }

    public VkDescriptorSetLayout Handle { get; }

    public LayoutEntry[] Entries { get; }

    public int UniformCount { get; }

    public bool HasStorageImages { get; }

    public VkPipelineStageFlags2 Stages { get; }

    public void Dispose() => Vk.vkDestroyDescriptorSetLayout(context.Handle, Handle, null);

    private static VkPipelineStageFlags2 StageMask(ShaderStage? stage) => stage switch
    {
        ShaderStage.Vertex => VkPipelineStageFlags2.VertexShader,
        ShaderStage.Geometry => VkPipelineStageFlags2.GeometryShader,
        ShaderStage.Fragment => VkPipelineStageFlags2.FragmentShader,
        _ => VkPipelineStageFlags2.ComputeShader,
    };

    private void CheckLimits(DeviceContext device, string name)
    {
        Check(VkDescriptorType.StorageBuffer, device.Limits.MaxStorageBuffersPerStage, "structured and byte-address buffers");
        Check(VkDescriptorType.StorageImage, device.Limits.MaxStorageImagesPerStage, "RW textures");
        Check(VkDescriptorType.UniformBufferDynamic, device.Limits.MaxUniformBuffersPerPipeline, "constant buffers");

        void Check(VkDescriptorType type, int limit, string what)
        {
            int count = Entries.Count(entry => entry.Type == type);
            if (count > limit)
            {
                throw new GpuException($"Shader '{name}' binds {count} {what}; device '{device.Adapter.Name}' has {limit}.");
            }
        }
    }
}
