using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>A compute kernel ready to run.</summary>
public sealed unsafe class GpuComputePipeline : GpuPipeline
{
    internal GpuComputePipeline(DeviceContext context, VkPipelineCache cache, ShaderBinary shader) : base(shader.EntryPoint)
    {
        Shader = shader;
        CheckLimits(context);
        ShaderBinary runs = context.Instrument(shader);
        Stages = [new StageLayout(context, runs, Name)];
        Layout = ShaderStages.CreateLayout(context, Stages, Name);
        Handle = Create(context, cache, runs);
        context.SetName(VkObjectType.Pipeline, Handle.Handle, Name);
    }

    /// <summary>The shader it was made from.</summary>
    public ShaderBinary Shader { get; }

    internal override VkPipelineBindPoint BindPoint => VkPipelineBindPoint.Compute;

    private VkPipeline Create(DeviceContext context, VkPipelineCache cache, ShaderBinary runs)
    {
        using Utf8Texts texts = new();
        VkShaderModule module = ShaderStages.CreateModule(context, runs, Name);
        VkComputePipelineCreateInfo info = new()
        {
            flags = context.Features.PipelineFlags,
            stage = new VkPipelineShaderStageCreateInfo
            {
                stage = VkShaderStageFlags.Compute,
                module = module,
                pName = texts.Add(Shader.EntryPoint),
            },
            layout = Layout,
        };
        VkPipeline pipeline;
        VkResult result = Vk.vkCreateComputePipelines(context.Handle, cache, 1, &info, null, &pipeline);
        Vk.vkDestroyShaderModule(context.Handle, module, null);
        result.Check($"Compiling kernel '{Name}' on '{context.Adapter.Name}'");
        return pipeline;
    }

    private void CheckLimits(DeviceContext context)
    {
        GpuLimits limits = context.Limits;
        int threads = Shader.GroupX * Shader.GroupY * Shader.GroupZ;
        (int x, int y, int z) = limits.MaxComputeGroupSize;
        if (Shader.Stage != ShaderStage.Compute)
        {
            throw new GpuException($"'{Name}' is a {Shader.Stage} shader, not a kernel.");
        }

        if (threads > limits.MaxComputeGroupInvocations || Shader.GroupX > x || Shader.GroupY > y || Shader.GroupZ > z)
        {
            throw new GpuException(
                $"Kernel '{Name}' has groups of {Shader.GroupX} x {Shader.GroupY} x {Shader.GroupZ} threads; device '{context.Adapter.Name}' " +
                $"allows {x} x {y} x {z} and {limits.MaxComputeGroupInvocations} in all.");
        }

        if (Shader.SharedBytes > limits.MaxSharedMemory)
        {
            throw new GpuException(
                $"Kernel '{Name}' uses {Shader.SharedBytes} bytes of groupshared memory; device '{context.Adapter.Name}' has {limits.MaxSharedMemory}.");
        }
    }
}
