using Headless.Engine;

namespace UnityEngine;

public sealed partial class GraphicsBuffer
{
    public void SetCounterValue(uint counterValue) => BufferCounter.Set(Storage, counterValue);

    public static void CopyCount(GraphicsBuffer src, GraphicsBuffer dst, int dstOffsetBytes) =>
        BufferCounter.Copy(src.Storage, dst.Storage, dstOffsetBytes);

    public static void CopyCount(GraphicsBuffer src, ComputeBuffer dst, int dstOffsetBytes) =>
        BufferCounter.Copy(src.Storage, dst.Storage, dstOffsetBytes);

    public static void CopyCount(ComputeBuffer src, GraphicsBuffer dst, int dstOffsetBytes) =>
        BufferCounter.Copy(src.Storage, dst.Storage, dstOffsetBytes);

    public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes) =>
        BufferCounter.Copy(src.Storage, dst.Storage, dstOffsetBytes);
}
