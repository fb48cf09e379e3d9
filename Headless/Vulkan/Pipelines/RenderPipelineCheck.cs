using Headless.Shaders;

namespace Headless.Vulkan;

/// <summary>Tells what is wrong with a description before the driver sees it.</summary>
internal static class RenderPipelineCheck
{
    public static void Validate(DeviceContext context, RenderPipelineDescription d, string name)
    {
        string device = context.Adapter.Name;
        if (d.Stages.Count(stage => stage.Stage == ShaderStage.Vertex) != 1 || d.Stages.Any(stage => stage.Stage == ShaderStage.Compute))
        {
            throw new GpuException($"Shader '{name}' needs exactly one vertex stage and no compute stage.");
        }

        if (d.Stages.Any(stage => stage.Stage == ShaderStage.Geometry) && !context.Limits.GeometryShader)
        {
            throw new GpuException($"Shader '{name}' has a geometry stage; device '{device}' has none. Use a shader without one.");
        }

        if (d.ColorFormats.Count > context.Limits.MaxColorTargets)
        {
            throw new GpuException($"Shader '{name}' draws to {d.ColorFormats.Count} targets; device '{device}' allows {context.Limits.MaxColorTargets}.");
        }

        if ((context.Limits.SampleCounts & d.Samples) == 0)
        {
            throw new GpuException($"Shader '{name}' wants {d.Samples} samples; device '{device}' does not have that count.");
        }

        if ((!d.DepthClip && context.Features.Core.depthClamp == 0) || (d.Wireframe && context.Features.Core.fillModeNonSolid == 0))
        {
            throw new GpuException($"Shader '{name}' needs depth clamping or wireframe, which device '{device}' does not have.");
        }

        int constants = d.Stages.Sum(stage => stage.Resources.Count(resource => resource.Kind == ResourceKind.ConstantBuffer));
        if (constants > context.Limits.MaxUniformBuffersPerPipeline)
        {
            throw new GpuException($"Shader '{name}' binds {constants} constant buffers; device '{device}' has {context.Limits.MaxUniformBuffersPerPipeline}.");
        }

        CheckWrites(context, d, name);
        CheckInputs(d, name);
    }

    private static void CheckWrites(DeviceContext context, RenderPipelineDescription d, string name)
    {
        foreach (ShaderBinary stage in d.Stages)
        {
            bool writes = stage.Resources.Any(r => r.Kind is ResourceKind.RWStructuredBuffer or ResourceKind.RWByteAddressBuffer or ResourceKind.RWTexture);
            bool allowed = stage.Stage == ShaderStage.Fragment
                ? context.Features.Core.fragmentStoresAndAtomics != 0
                : context.Limits.VertexStageWrites;
            if (writes && !allowed)
            {
                throw new GpuException($"Shader '{name}' writes buffers in its {stage.Stage} stage; device '{context.Adapter.Name}' cannot.");
            }
        }
    }

    private static void CheckInputs(RenderPipelineDescription d, string name)
    {
        ShaderBinary vertex = d.Stages.First(stage => stage.Stage == ShaderStage.Vertex);
        foreach (VertexInput input in vertex.Inputs)
        {
            if (!d.Attributes.Any(attribute => attribute.Location == input.Location))
            {
                throw new GpuException($"Shader '{name}' reads the vertex attribute {input.Semantic}, which the mesh's layout does not have.");
            }
        }

        foreach (VertexAttribute attribute in d.Attributes)
        {
            if (!d.Streams.Any(stream => stream.Slot == attribute.Slot))
            {
                throw new GpuException($"Shader '{name}': attribute at location {attribute.Location} names slot {attribute.Slot}, which no stream has.");
            }
        }
    }
}
