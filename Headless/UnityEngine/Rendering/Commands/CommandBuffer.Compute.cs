using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ) =>
        Add(new DispatchCommand(Require(computeShader), kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ));

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, ComputeBuffer buffer) =>
        SetComputeBufferParam(computeShader, kernelIndex, ShaderNames.Id(name), buffer);

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, ComputeBuffer buffer) =>
        Add(new SetComputeBufferCommand(Require(computeShader), kernelIndex, nameID, buffer?.Storage));

    public void SetComputeConstantBufferParam(ComputeShader computeShader, string name, ComputeBuffer buffer, int offset, int size) =>
        SetComputeConstantBufferParam(computeShader, ShaderNames.Id(name), buffer, offset, size);

    public void SetComputeConstantBufferParam(ComputeShader computeShader, int nameID, ComputeBuffer buffer, int offset, int size)
    {
        DeviceBuffer? storage = buffer?.Storage;
        Add(_ => computeShader.BindConstantBuffer(nameID, storage, offset, size));
    }

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, ComputeBuffer indirectBuffer, uint argsOffset)
    {
        DeviceBuffer? storage = indirectBuffer?.Storage;
        Add(_ => ComputeDispatcher.DispatchIndirect(computeShader, kernelIndex, storage, argsOffset));
    }

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, string name, GraphicsBuffer buffer) =>
        SetComputeBufferParam(computeShader, kernelIndex, ShaderNames.Id(name), buffer);

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBuffer buffer) =>
        Add(new SetComputeBufferCommand(Require(computeShader), kernelIndex, nameID, buffer?.Storage));

    public void SetComputeConstantBufferParam(ComputeShader computeShader, string name, GraphicsBuffer buffer, int offset, int size) =>
        SetComputeConstantBufferParam(computeShader, ShaderNames.Id(name), buffer, offset, size);

    public void SetComputeConstantBufferParam(ComputeShader computeShader, int nameID, GraphicsBuffer buffer, int offset, int size)
    {
        DeviceBuffer? storage = buffer?.Storage;
        Add(_ => computeShader.BindConstantBuffer(nameID, storage, offset, size));
    }

    public void DispatchCompute(ComputeShader computeShader, int kernelIndex, GraphicsBuffer indirectBuffer, uint argsOffset)
    {
        DeviceBuffer? storage = indirectBuffer?.Storage;
        Add(_ => ComputeDispatcher.DispatchIndirect(computeShader, kernelIndex, storage, argsOffset));
    }

    public void SetComputeBufferParam(ComputeShader computeShader, int kernelIndex, int nameID, GraphicsBufferHandle bufferHandle) =>
        Add(new SetComputeBufferCommand(Require(computeShader), kernelIndex, nameID, BufferHandles.Find(bufferHandle)));

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt) =>
        SetComputeTextureParam(computeShader, kernelIndex, ShaderNames.Id(name), rt);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt) =>
        SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, 0);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, string name, RenderTargetIdentifier rt, int mipLevel) =>
        SetComputeTextureParam(computeShader, kernelIndex, ShaderNames.Id(name), rt, mipLevel);

    public void SetComputeTextureParam(ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt, int mipLevel) =>
        SetComputeTextureParam(computeShader, kernelIndex, nameID, rt, mipLevel, RenderTextureSubElement.Default);

    public void SetComputeTextureParam(
        ComputeShader computeShader, int kernelIndex, int nameID, RenderTargetIdentifier rt, int mipLevel, RenderTextureSubElement element)
    {
        Require(computeShader);
        Add(c => computeShader.BindTexture(kernelIndex, nameID, new TextureSlot(c.Texture(rt), mipLevel, element)));
    }

    public void EnableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, true);

    public void DisableKeyword(ComputeShader computeShader, in LocalKeyword keyword) => SetKeyword(computeShader, keyword, false);

    public void SetKeyword(ComputeShader computeShader, in LocalKeyword keyword, bool value)
    {
        string keywordName = keyword.name;
        Require(computeShader);
        Add(_ => computeShader.Program.Keywords.Change(keywordName, value));
    }
}
