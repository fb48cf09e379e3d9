using Headless.Shaders;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Makes graphics pipelines.</summary>
internal sealed unsafe class RenderPipelineBuilder(DeviceContext context, VkPipelineCache cache)
{
    public GpuRenderPipeline Build(RenderPipelineDescription description)
    {
        string name = RenderPipelineKey.NameOf(description);
        RenderPipelineCheck.Validate(context, description, name);
        description = description with { Stages = [.. description.Stages.Select(context.Instrument)] };
        StageLayout[] layouts = new StageLayout[ResourceBindings.SetCount];
        for (int set = 0; set < layouts.Length; set++)
        {
            layouts[set] = new StageLayout(context, description.Stages.FirstOrDefault(stage => stage.DescriptorSet == set), name);
        }

        VkPipelineLayout layout = ShaderStages.CreateLayout(context, layouts, name);
        VkPipeline handle = Create(description, layout, name);
        context.SetName(VkObjectType.Pipeline, handle.Handle, name);
        return new GpuRenderPipeline(description, layouts, layout, handle);
    }

    private VkPipeline Create(RenderPipelineDescription d, VkPipelineLayout layout, string name)
    {
        using Utf8Texts texts = new();
        VkPipelineShaderStageCreateInfo* stages = stackalloc VkPipelineShaderStageCreateInfo[d.Stages.Count];
        for (int i = 0; i < d.Stages.Count; i++)
        {
            stages[i] = new VkPipelineShaderStageCreateInfo
            {
                stage = ShaderStages.Flag(d.Stages[i].Stage),
                module = ShaderStages.CreateModule(context, d.Stages[i], name),
                pName = texts.Add(d.Stages[i].EntryPoint),
            };
        }

        VkVertexInputBindingDescription* streams = stackalloc VkVertexInputBindingDescription[d.Streams.Count];
        VkVertexInputAttributeDescription* attributes = stackalloc VkVertexInputAttributeDescription[d.Attributes.Count];
        VkPipelineVertexInputStateCreateInfo vertex = VertexInput(d, streams, attributes);
        VkPipelineInputAssemblyStateCreateInfo assembly = new() { topology = VulkanStates.Topology(d.Topology) };
        VkPipelineViewportStateCreateInfo viewport = new() { viewportCount = 1, scissorCount = 1 };
        VkPipelineRasterizationStateCreateInfo raster = Raster(d);
        VkPipelineMultisampleStateCreateInfo samples = new()
        {
            rasterizationSamples = (VkSampleCountFlags)d.Samples,
            alphaToCoverageEnable = d.AlphaToCoverage ? 1u : 0u,
        };
        VkPipelineDepthStencilStateCreateInfo depth = Depth(d);
        VkPipelineColorBlendAttachmentState* blends = stackalloc VkPipelineColorBlendAttachmentState[d.ColorFormats.Count];
        VkFormat* formats = stackalloc VkFormat[d.ColorFormats.Count];
        for (int i = 0; i < d.ColorFormats.Count; i++)
        {
            formats[i] = FormatTable.Of(d.ColorFormats[i]).Format;
            blends[i] = VulkanStates.Blend(d.Blend.Count == 0 ? new BlendState() : d.Blend[Math.Min(i, d.Blend.Count - 1)]);
        }

        VkPipelineColorBlendStateCreateInfo blend = new() { attachmentCount = (uint)d.ColorFormats.Count, pAttachments = blends };
        VkDynamicState* dynamic = stackalloc VkDynamicState[] { VkDynamicState.Viewport, VkDynamicState.Scissor };
        VkPipelineDynamicStateCreateInfo dynamics = new() { dynamicStateCount = 2, pDynamicStates = dynamic };
        VkPipelineRenderingCreateInfo targets = new()
        {
            colorAttachmentCount = (uint)d.ColorFormats.Count,
            pColorAttachmentFormats = formats,
            depthAttachmentFormat = d.DepthFormat == GpuFormat.None ? VkFormat.Undefined : FormatTable.Of(d.DepthFormat).Format,
        };
        VkGraphicsPipelineCreateInfo info = new()
        {
            pNext = &targets,
            flags = context.Features.PipelineFlags,
            stageCount = (uint)d.Stages.Count,
            pStages = stages,
            pVertexInputState = &vertex,
            pInputAssemblyState = &assembly,
            pViewportState = &viewport,
            pRasterizationState = &raster,
            pMultisampleState = &samples,
            pDepthStencilState = &depth,
            pColorBlendState = &blend,
            pDynamicState = &dynamics,
            layout = layout,
        };
        VkPipeline pipeline;
        VkResult result = Vk.vkCreateGraphicsPipelines(context.Handle, cache, 1, &info, null, &pipeline);
        for (int i = 0; i < d.Stages.Count; i++)
        {
            Vk.vkDestroyShaderModule(context.Handle, stages[i].module, null);
        }

        result.Check($"Compiling shader '{name}' on '{context.Adapter.Name}'");
        return pipeline;
    }

    private static VkPipelineVertexInputStateCreateInfo VertexInput(
        RenderPipelineDescription d, VkVertexInputBindingDescription* streams, VkVertexInputAttributeDescription* attributes)
    {
        for (int i = 0; i < d.Streams.Count; i++)
        {
            streams[i] = new VkVertexInputBindingDescription
            {
                binding = (uint)d.Streams[i].Slot,
                stride = (uint)d.Streams[i].Stride,
                inputRate = d.Streams[i].PerInstance ? VkVertexInputRate.Instance : VkVertexInputRate.Vertex,
            };
        }

        int used = 0;
        ShaderBinary shader = d.Stages.First(stage => stage.Stage == ShaderStage.Vertex);
        foreach (VertexAttribute attribute in d.Attributes.Where(a => shader.Inputs.Any(input => input.Location == a.Location)))
        {
            attributes[used++] = new VkVertexInputAttributeDescription
            {
                location = (uint)attribute.Location,
                binding = (uint)attribute.Slot,
                format = VulkanStates.Vertex(attribute.Format),
                offset = (uint)attribute.Offset,
            };
        }

        return new VkPipelineVertexInputStateCreateInfo
        {
            vertexBindingDescriptionCount = (uint)d.Streams.Count,
            pVertexBindingDescriptions = streams,
            vertexAttributeDescriptionCount = (uint)used,
            pVertexAttributeDescriptions = attributes,
        };
    }

    private VkPipelineRasterizationStateCreateInfo Raster(RenderPipelineDescription d) => new()
    {
        depthClampEnable = d.DepthClip ? 0u : 1u,
        polygonMode = d.Wireframe ? VkPolygonMode.Line : VkPolygonMode.Fill,
        cullMode = VulkanStates.Cull(d.Cull),
        frontFace = d.FrontClockwise ? VkFrontFace.Clockwise : VkFrontFace.CounterClockwise,
        depthBiasEnable = d.DepthBiasSlope != 0 || d.DepthBiasUnits != 0 ? 1u : 0u,
        depthBiasConstantFactor = d.DepthBiasUnits,
        depthBiasSlopeFactor = d.DepthBiasSlope,
        lineWidth = 1,
    };

    private static VkPipelineDepthStencilStateCreateInfo Depth(RenderPipelineDescription d)
    {
        bool used = d.DepthFormat != GpuFormat.None && (d.DepthWrite || d.DepthCompare != GpuCompare.Always);
        return new VkPipelineDepthStencilStateCreateInfo
        {
            depthTestEnable = used ? 1u : 0u,
            depthWriteEnable = used && d.DepthWrite ? 1u : 0u,
            depthCompareOp = VulkanStates.Compare(d.DepthCompare),
            maxDepthBounds = 1,
        };
    }
}
