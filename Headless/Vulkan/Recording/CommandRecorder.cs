namespace Headless.Vulkan;

/// <summary>Records work in order; every command sees what all earlier ones wrote, as on D3D11's immediate context.</summary>
/// <remarks>
/// Barriers are put in where a buffer or texture is read after a write, written after a read or written twice.
/// A copy or dispatch inside <see cref="BeginRendering"/> pauses drawing and goes on with the targets' content kept.
/// One thread at a time. Work is submitted by <see cref="Submit"/>, by blocking reads, and by itself when a command buffer is full.
/// </remarks>
public sealed class CommandRecorder
{
    private readonly CommandStream stream;
    private readonly ComputeCommands compute;
    private readonly CopyCommands copy;
    private readonly TextureCopyCommands textureCopy;
    private readonly DrawCommands draw;
    private readonly TimerCommands timers;

    internal CommandRecorder(CommandStream stream, TimerCommands timers)
    {
        this.stream = stream;
        this.timers = timers;
        compute = new ComputeCommands(stream);
        copy = new CopyCommands(stream);
        textureCopy = new TextureCopyCommands(stream);
        draw = new DrawCommands(stream);
    }

    /// <summary>Barriers recorded so far by this device.</summary>
    public long BarrierCount => stream.Hazards.BarrierCount;

    /// <summary>Barriers among them that order dispatches alone.</summary>
    public long ComputeBarrierCount => stream.Hazards.ComputeBarrierCount;

    /// <summary>Dispatches, draws, copies, fills and clears recorded so far by this device.</summary>
    public long CommandCount => stream.CommandCount;

    /// <summary>Dispatches and draws among them: what runs shaders.</summary>
    public long WorkCount => stream.WorkCount;

    /// <summary>Runs x * y * z groups; 0 groups in a dimension record nothing.</summary>
    /// <exception cref="GpuException">A resource of the kernel is not bound, or a group count is over the limit.</exception>
    public void Dispatch(GpuComputePipeline pipeline, ResourceBindings bindings, uint x, uint y, uint z) =>
        compute.Dispatch(pipeline, bindings, x, y, z);

    /// <summary>Runs as many groups as the three uints at <paramref name="offset"/> (a multiple of 4 bytes) of <paramref name="arguments"/> say.</summary>
    public void DispatchIndirect(GpuComputePipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset) =>
        compute.DispatchIndirect(pipeline, bindings, arguments, offset);

    /// <summary>Writes bytes into a buffer.</summary>
    public void UpdateBuffer(GpuBuffer buffer, long offset, ReadOnlySpan<byte> data) => copy.Update(buffer, offset, data);

    /// <summary>Copies bytes between buffers; ranges of one buffer may not overlap.</summary>
    public void CopyBuffer(GpuBuffer source, long sourceOffset, GpuBuffer target, long targetOffset, long size) =>
        copy.Copy(source, sourceOffset, target, targetOffset, size);

    /// <summary>Repeats a 32-bit value; offset and size are multiples of 4 bytes.</summary>
    public void FillBuffer(GpuBuffer buffer, long offset, long size, uint value) => copy.Fill(buffer, offset, size, value);

    /// <summary>Writes one whole mip level of one layer (all slices of a 3D texture); rows tightly packed, first row at the top.</summary>
    public void UpdateTexture(GpuTexture texture, int mipLevel, int layer, ReadOnlySpan<byte> data) =>
        textureCopy.Update(texture, mipLevel, layer, data);

    /// <summary>Copies all texels of one mip level and layer between textures of the same format, size and sample count.</summary>
    public void CopyTexture(GpuTexture source, int sourceMip, int sourceLayer, GpuTexture target, int targetMip, int targetLayer) =>
        textureCopy.Copy(source, sourceMip, sourceLayer, target, targetMip, targetLayer);

    /// <summary>Sets all texels of a texture to zero.</summary>
    public void ClearTexture(GpuTexture texture) => textureCopy.Clear(texture);

    /// <summary>
    /// Sets all texels to what shows where it is used: NaN in float formats, the largest value in unsigned ones, -1 in signed
    /// ones, and 1 (nearest in reversed depth, so that nothing is drawn behind it) in depth.
    /// </summary>
    public void PoisonTexture(GpuTexture texture) => textureCopy.Poison(texture);

    /// <summary>Averages a multisampled color texture into a one-sample texture of the same format and size.</summary>
    public void ResolveTexture(GpuTexture source, GpuTexture target) => textureCopy.Resolve(source, target);

    /// <summary>Fills mip levels 1 and up from level 0, each texel the mean of the four (3D: eight) above it.</summary>
    public void GenerateMips(GpuTexture texture) => textureCopy.GenerateMips(texture);

    /// <summary>Begins drawing to targets; a missing <see cref="EndRendering"/> before the next begin is an error.</summary>
    public void BeginRendering(RenderTargets targets) => draw.Begin(targets);

    /// <summary>Sets the viewport of the following draws; scissor goes back to the whole viewport.</summary>
    public void SetViewport(GpuViewport viewport) => draw.SetViewport(viewport);

    /// <summary>Restricts the following draws to a rectangle of texels.</summary>
    public void SetScissor(int x, int y, int width, int height) => draw.SetScissor(x, y, width, height);

    /// <summary>Binds a vertex buffer to a slot of the vertex layout; null unbinds.</summary>
    public void SetVertexBuffer(int slot, GpuBuffer? buffer, long offset = 0) => draw.SetVertexBuffer(slot, buffer, offset);

    /// <summary>Binds the index buffer; 16-bit indices unless <paramref name="wide"/>.</summary>
    public void SetIndexBuffer(GpuBuffer buffer, long offset, bool wide) => draw.SetIndexBuffer(buffer, offset, wide);

    /// <summary>Draws vertices.</summary>
    public void Draw(
        GpuRenderPipeline pipeline, ResourceBindings bindings, uint vertexCount, uint instanceCount = 1,
        uint firstVertex = 0, uint firstInstance = 0) =>
        draw.Draw(pipeline, bindings, vertexCount, instanceCount, firstVertex, firstInstance);

    /// <summary>Draws indexed vertices.</summary>
    public void DrawIndexed(
        GpuRenderPipeline pipeline, ResourceBindings bindings, uint indexCount, uint instanceCount = 1,
        uint firstIndex = 0, int baseVertex = 0, uint firstInstance = 0) =>
        draw.DrawIndexed(pipeline, bindings, indexCount, instanceCount, firstIndex, baseVertex, firstInstance);

    /// <summary>Draws with the four uints (vertices, instances, first vertex, first instance) at <paramref name="offset"/> bytes.</summary>
    public void DrawIndirect(GpuRenderPipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset) =>
        draw.DrawIndirect(pipeline, bindings, arguments, offset);

    /// <summary>Draws with the five uints (indices, instances, first index, base vertex, first instance) at <paramref name="offset"/> bytes.</summary>
    public void DrawIndexedIndirect(GpuRenderPipeline pipeline, ResourceBindings bindings, GpuBuffer arguments, long offset) =>
        draw.DrawIndexedIndirect(pipeline, bindings, arguments, offset);

    /// <summary>Ends drawing; multisampled targets are resolved.</summary>
    public void EndRendering() => draw.End();

    /// <summary>Opens a timer scope inside the open ones and returns its id.</summary>
    public int BeginTimer(string name) => timers.Begin(name);

    /// <summary>Closes a timer scope.</summary>
    public void EndTimer(int id) => timers.End(id);

    /// <summary>Hands the recorded work to the device and returns its ticket (see <see cref="GpuDevice.IsComplete"/>).</summary>
    public ulong Submit() => stream.Submit();
}
