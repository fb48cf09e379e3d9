namespace UnityEngine.Rendering;

public struct CommandBufferHelpers
{
    public static RasterCommandBuffer GetRasterCommandBuffer(CommandBuffer baseBuffer) => new(baseBuffer);

    public static UnsafeCommandBuffer GetUnsafeCommandBuffer(CommandBuffer baseBuffer) => new(baseBuffer);

    public static ComputeCommandBuffer GetComputeCommandBuffer(CommandBuffer baseBuffer) => new(baseBuffer);

    public static CommandBuffer GetNativeCommandBuffer(UnsafeCommandBuffer baseBuffer) => baseBuffer.Wrapped;
}
