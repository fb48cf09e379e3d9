using Headless.Engine;

namespace UnityEngine;

public sealed partial class ComputeBuffer
{
    public void SetCounterValue(uint counterValue) => BufferCounter.Set(Storage, counterValue);

    public static void CopyCount(ComputeBuffer src, ComputeBuffer dst, int dstOffsetBytes) =>
        BufferCounter.Copy(src.Storage, dst.Storage, dstOffsetBytes);
}
