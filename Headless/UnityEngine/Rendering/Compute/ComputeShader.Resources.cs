using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class ComputeShader
{
    public void SetBuffer(int kernelIndex, string name, ComputeBuffer buffer) => SetBuffer(kernelIndex, ShaderNames.Id(name), buffer);

    public void SetBuffer(int kernelIndex, int nameID, ComputeBuffer buffer) => BindBuffer(kernelIndex, nameID, Require(buffer).Storage);

    public void SetBuffer(int kernelIndex, string name, GraphicsBuffer buffer) => SetBuffer(kernelIndex, ShaderNames.Id(name), buffer);

    public void SetBuffer(int kernelIndex, int nameID, GraphicsBuffer buffer) => BindBuffer(kernelIndex, nameID, Require(buffer).Storage);

    public void SetConstantBuffer(string name, ComputeBuffer buffer, int offset, int size) =>
        SetConstantBuffer(ShaderNames.Id(name), buffer, offset, size);

    public void SetConstantBuffer(int nameID, ComputeBuffer buffer, int offset, int size) =>
        BindConstantBuffer(nameID, buffer?.Storage, offset, size);

    public void SetConstantBuffer(string name, GraphicsBuffer buffer, int offset, int size) =>
        SetConstantBuffer(ShaderNames.Id(name), buffer, offset, size);

    public void SetConstantBuffer(int nameID, GraphicsBuffer buffer, int offset, int size) =>
        BindConstantBuffer(nameID, buffer?.Storage, offset, size);

    public void SetTexture(int kernelIndex, string name, Texture texture) => SetTexture(kernelIndex, ShaderNames.Id(name), texture, 0);

    public void SetTexture(int kernelIndex, int nameID, Texture texture) => SetTexture(kernelIndex, nameID, texture, 0);

    public void SetTexture(int kernelIndex, string name, Texture texture, int mipLevel) =>
        SetTexture(kernelIndex, ShaderNames.Id(name), texture, mipLevel);

    public void SetTexture(int kernelIndex, int nameID, Texture texture, int mipLevel) =>
        BindTexture(kernelIndex, nameID, new TextureSlot(texture, mipLevel));

    public void SetTexture(int kernelIndex, string name, RenderTexture texture, int mipLevel, RenderTextureSubElement element) =>
        SetTexture(kernelIndex, ShaderNames.Id(name), texture, mipLevel, element);

    public void SetTexture(int kernelIndex, int nameID, RenderTexture texture, int mipLevel, RenderTextureSubElement element) =>
        BindTexture(kernelIndex, nameID, new TextureSlot(texture, mipLevel, element));

    public void SetTextureFromGlobal(int kernelIndex, string name, string globalTextureName) =>
        SetTextureFromGlobal(kernelIndex, ShaderNames.Id(name), ShaderNames.Id(globalTextureName));

    public void SetTextureFromGlobal(int kernelIndex, int nameID, int globalTextureNameID)
    {
        if (Program.Kernel(kernelIndex) is { } kernel)
        {
            kernel.Textures.Remove(nameID);
            kernel.GlobalTextures[nameID] = globalTextureNameID;
        }
    }

    internal void BindBuffer(int kernelIndex, int nameID, DeviceBuffer? buffer)
    {
        if (Program.Kernel(kernelIndex) is { } kernel)
        {
            kernel.Buffers[nameID] = new BufferSlot(buffer);
        }
    }

    internal void BindTexture(int kernelIndex, int nameID, TextureSlot slot)
    {
        if (Program.Kernel(kernelIndex) is { } kernel)
        {
            kernel.Textures[nameID] = slot;
            kernel.GlobalTextures.Remove(nameID);
        }
    }

    internal void BindConstantBuffer(int nameID, DeviceBuffer? buffer, int offset, int size)
    {
        if (buffer is null)
        {
            Program.State.ConstantBuffers.Remove(nameID);
            return;
        }

        ConstantRanges.Check(buffer, offset, size, name);
        Program.State.ConstantBuffers[nameID] = new BufferSlot(buffer, offset, size);
    }

    private static T Require<T>(T buffer)
        where T : class => buffer ?? throw new ArgumentNullException(nameof(buffer));
}
