using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Records draws; the rendering instance opens with the first draw and pauses for copies, dispatches and barriers.</summary>
internal sealed unsafe class DrawCommands
{
    private readonly CommandStream stream;
    private readonly RenderingScope scope;
    private readonly VertexInputs inputs = new();
    private ulong stateTicket;
    private GpuViewport viewport;
    private VkRect2D scissor;
    private bool viewDirty;

    public DrawCommands(CommandStream stream)
    {
        this.stream = stream;
        scope = new RenderingScope(stream);
        stream.LeaveRendering = scope.Pause;
    }

    public void Begin(RenderTargets targets)
    {
        scope.Open(targets);
        SetViewport(targets.Viewport ?? new GpuViewport(0, 0, scope.Width, scope.Height));
    }

    public void End() => scope.Close();

    public void SetViewport(GpuViewport value)
    {
        viewport = value;
        SetScissor((int)MathF.Floor(value.X), (int)MathF.Floor(value.Y), (int)MathF.Ceiling(value.Width), (int)MathF.Ceiling(value.Height));
    }

    public void SetScissor(int x, int y, int width, int height)
    {
        int left = Math.Clamp(x, 0, scope.Width);
        int top = Math.Clamp(y, 0, scope.Height);
        int right = Math.Clamp(x + width, left, scope.Width);
        int bottom = Math.Clamp(y + height, top, scope.Height);
        scissor.offset = new VkOffset2D { x = left, y = top };
        scissor.extent = new VkExtent2D { width = (uint)(right - left), height = (uint)(bottom - top) };
        viewDirty = true;
    }

    public void SetVertexBuffer(int slot, GpuBuffer? buffer, long offset) => inputs.SetVertexBuffer(slot, buffer, offset);

    public void SetIndexBuffer(GpuBuffer buffer, long offset, bool wide) => inputs.SetIndexBuffer(buffer, offset, wide);

    public void Draw(GpuRenderPipeline pipeline, ResourceBindings bindings, uint vertices, uint instances, uint firstVertex, uint firstInstance)
    {
        if (vertices == 0 || instances == 0)
        {
            return;
        }

        Prepare(pipeline, bindings, indexed: false, null);
        Vk.vkCmdDraw(stream.Commands, vertices, instances, firstVertex, firstInstance);
        stream.CountWork(((long)vertices * instances) + Pixels);
    }

    public void DrawIndexed(
        GpuRenderPipeline pipeline, ResourceBindings bindings, uint indices, uint instances, uint firstIndex, int baseVertex, uint firstInstance)
    {
        if (indices == 0 || instances == 0)
        {
            return;
        }

        Prepare(pipeline, bindings, indexed: true, null);
        Vk.vkCmdDrawIndexed(stream.Commands, indices, instances, firstIndex, baseVertex, firstInstance);
        stream.CountWork(((long)indices * instances) + Pixels);
    }

    public void DrawIndirect(GpuRenderPipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset)
    {
        ComputeCommands.CheckArguments(arguments, offset, sizeof(VkDrawIndirectCommand), $"Indirect draw of '{pipeline.Name}'");
        Prepare(pipeline, bindings, indexed: false, arguments);
        Vk.vkCmdDrawIndirect(stream.Commands, arguments.Handle, (ulong)offset, 1, (uint)sizeof(VkDrawIndirectCommand));
        stream.CountWork(CommandStream.UnknownWork + Pixels);
    }

    public void DrawIndexedIndirect(GpuRenderPipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset)
    {
        ComputeCommands.CheckArguments(arguments, offset, sizeof(VkDrawIndexedIndirectCommand), $"Indirect draw of '{pipeline.Name}'");
        Prepare(pipeline, bindings, indexed: true, arguments);
        Vk.vkCmdDrawIndexedIndirect(stream.Commands, arguments.Handle, (ulong)offset, 1, (uint)sizeof(VkDrawIndexedIndirectCommand));
        stream.CountWork(CommandStream.UnknownWork + Pixels);
    }

    private long Pixels => (long)scope.Width * scope.Height;

    private void Prepare(GpuRenderPipeline pipeline, ResourceBindings bindings, bool indexed, GpuBuffer? arguments)
    {
        stream.Begin(insideRendering: true);
        scope.Check(pipeline);
        HazardTracker hazards = stream.Hazards;
        stream.Binder.Gather(pipeline, bindings, stream.Current, hazards);
        inputs.Gather(pipeline, indexed, hazards);
        if (arguments is not null)
        {
            hazards.Read(arguments, VkPipelineStageFlags2.DrawIndirect);
        }

        scope.Enter();
        VkCommandBuffer commands = stream.Commands;
        bool fresh = stateTicket != stream.Current.Ticket;
        stateTicket = stream.Current.Ticket;
        if (fresh || viewDirty)
        {
            SetView(commands);
        }

        stream.Binder.Bind(commands, pipeline);
        inputs.Bind(commands, pipeline, indexed, fresh);
    }

    /// <summary>A viewport of negative height turns Vulkan's clip space into D3D11's (y up).</summary>
    private void SetView(VkCommandBuffer commands)
    {
        VkViewport view = new()
        {
            x = viewport.X,
            y = viewport.Y + viewport.Height,
            width = viewport.Width,
            height = -viewport.Height,
            minDepth = viewport.MinDepth,
            maxDepth = viewport.MaxDepth,
        };
        VkRect2D area = scissor;
        Vk.vkCmdSetViewport(commands, 0, 1, &view);
        Vk.vkCmdSetScissor(commands, 0, 1, &area);
        viewDirty = false;
    }
}
