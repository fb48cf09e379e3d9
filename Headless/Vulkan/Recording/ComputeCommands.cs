using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Records dispatches.</summary>
internal sealed class ComputeCommands(CommandStream stream)
{
    public void Dispatch(GpuComputePipeline pipeline, ResourceBindings bindings, uint x, uint y, uint z)
    {
        if (x == 0 || y == 0 || z == 0)
        {
            return;
        }

        (uint maxX, uint maxY, uint maxZ) = stream.Context.Limits.MaxGroupCount;
        if (x > maxX || y > maxY || z > maxZ)
        {
            throw new GpuException(
                $"Kernel '{pipeline.Name}': {x} x {y} x {z} groups; device '{stream.Context.Adapter.Name}' allows {maxX} x {maxY} x {maxZ}. " +
                "Spread the groups over more dimensions or several dispatches.");
        }

        pipeline = Prepare(pipeline, bindings);
        stream.Hazards.Commit(stream.Commands);
        stream.Binder.Bind(stream.Commands, pipeline);
        Vk.vkCmdDispatch(stream.Commands, x, y, z);
        stream.CountWork((long)x * y * z * pipeline.Shader.GroupX * pipeline.Shader.GroupY * pipeline.Shader.GroupZ);
    }

    public void DispatchIndirect(GpuComputePipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset)
    {
        CheckArguments(arguments, offset, 12, $"Indirect dispatch of '{pipeline.Name}'");
        pipeline = Prepare(pipeline, bindings);
        stream.Hazards.Read(arguments, VkPipelineStageFlags2.DrawIndirect);
        stream.Hazards.Commit(stream.Commands);
        stream.Binder.Bind(stream.Commands, pipeline);
        Vk.vkCmdDispatchIndirect(stream.Commands, arguments.Handle, (ulong)offset);
        stream.CountWork(CommandStream.UnknownWork);
    }

    /// <summary>Throws unless <paramref name="bytes"/> of arguments lie in a buffer for indirect use.</summary>
    public static void CheckArguments(GpuBuffer arguments, long offset, long bytes, string what)
    {
        arguments.CheckRange(offset, bytes, what);
        arguments.Require(BufferUse.Indirect, what, "arguments");
        if (offset % 4 != 0)
        {
            throw new GpuException($"{what}: the offset {offset} of the arguments is not a multiple of 4.");
        }
    }

    private GpuComputePipeline Prepare(GpuComputePipeline pipeline, ResourceBindings bindings)
    {
        stream.Begin();
        if (pipeline.Stages[0].HasStorageImages)
        {
            pipeline = stream.Pipelines.FitImageFormats(pipeline, bindings);
        }

        stream.Binder.Gather(pipeline, bindings, stream.Current, stream.Hazards);
        return pipeline;
    }
}
