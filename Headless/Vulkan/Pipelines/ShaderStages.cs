using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Shader stages and modules.</summary>
internal static unsafe class ShaderStages
{
    public static VkShaderStageFlags Flag(ShaderStage stage) => stage switch
    {
        ShaderStage.Vertex => VkShaderStageFlags.Vertex,
        ShaderStage.Geometry => VkShaderStageFlags.Geometry,
        ShaderStage.Fragment => VkShaderStageFlags.Fragment,
        _ => VkShaderStageFlags.Compute,
    };

    public static VkShaderModule CreateModule(DeviceContext context, ShaderBinary shader, string name)
    {
        fixed (byte* code = shader.SpirV)
        {
            VkShaderModuleCreateInfo info = new() { codeSize = (nuint)shader.SpirV.Length, pCode = (uint*)code };
            VkShaderModule module;
            Vk.vkCreateShaderModule(context.Handle, &info, null, &module).Check($"Loading shader '{name}'");
            return module;
        }
    }

    public static VkPipelineLayout CreateLayout(DeviceContext context, StageLayout[] stages, string name)
    {
        VkDescriptorSetLayout* sets = stackalloc VkDescriptorSetLayout[ResourceBindings.SetCount];
        for (int i = 0; i < stages.Length; i++)
        {
            sets[i] = stages[i].Handle;
        }

        VkPipelineLayoutCreateInfo info = new() { setLayoutCount = (uint)stages.Length, pSetLayouts = sets };
        VkPipelineLayout layout;
        Vk.vkCreatePipelineLayout(context.Handle, &info, null, &layout).Check($"Creating the layout of '{name}'");
        return layout;
    }
}
