using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void SetBufferCounterValue(GraphicsBuffer buffer, uint counterValue) => SetCounter(Require(buffer).Storage, counterValue);

    public void SetBufferCounterValue(ComputeBuffer buffer, uint counterValue) => SetCounter(Require(buffer).Storage, counterValue);

    public void CopyCounterValue(GraphicsBuffer src, GraphicsBuffer dst, uint dstOffsetBytes) =>
        CopyCounter(Require(src).Storage, Require(dst).Storage, dstOffsetBytes);

    public void CopyCounterValue(GraphicsBuffer src, ComputeBuffer dst, uint dstOffsetBytes) =>
        CopyCounter(Require(src).Storage, Require(dst).Storage, dstOffsetBytes);

    public void CopyCounterValue(ComputeBuffer src, GraphicsBuffer dst, uint dstOffsetBytes) =>
        CopyCounter(Require(src).Storage, Require(dst).Storage, dstOffsetBytes);

    public void CopyCounterValue(ComputeBuffer src, ComputeBuffer dst, uint dstOffsetBytes) =>
        CopyCounter(Require(src).Storage, Require(dst).Storage, dstOffsetBytes);

    public void SetRandomWriteTarget(int index, RenderTargetIdentifier rt) =>
        Add(c => RandomWriteTargets.Set(index, c.Texture(rt)));

    public void SetRandomWriteTarget(int index, ComputeBuffer buffer) => SetRandomWriteTarget(index, buffer, false);

    public void SetRandomWriteTarget(int index, ComputeBuffer buffer, bool preserveCounterValue) =>
        SetTarget(index, Require(buffer).Storage, preserveCounterValue);

    public void SetRandomWriteTarget(int index, GraphicsBuffer buffer) => SetRandomWriteTarget(index, buffer, false);

    public void SetRandomWriteTarget(int index, GraphicsBuffer buffer, bool preserveCounterValue) =>
        SetTarget(index, Require(buffer).Storage, preserveCounterValue);

    public void ClearRandomWriteTargets() => Add(_ => RandomWriteTargets.Clear());

    private void SetTarget(int index, DeviceBuffer buffer, bool preserveCounterValue)
    {
        RandomWriteTargets.CheckIndex(index);
        Add(_ => RandomWriteTargets.Set(index, buffer, preserveCounterValue));
    }

    private void SetCounter(DeviceBuffer buffer, uint value) => Add(_ => BufferCounter.Set(buffer, value));

    private void CopyCounter(DeviceBuffer source, DeviceBuffer target, uint offset) => Add(_ => BufferCounter.Copy(source, target, offset));
}
