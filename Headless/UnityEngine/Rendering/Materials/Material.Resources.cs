using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class Material
{
    public void SetTexture(string name, Texture value) => SetTexture(ShaderNames.Id(name), value);

    public void SetTexture(int nameID, Texture value) => Sheet.SetTexture(nameID, new TextureSlot(value));

    public void SetTexture(string name, RenderTexture value, RenderTextureSubElement element) => SetTexture(ShaderNames.Id(name), value, element);

    public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) => Sheet.SetTexture(nameID, new TextureSlot(value, 0, element));

    public void SetBuffer(string name, ComputeBuffer value) => SetBuffer(ShaderNames.Id(name), value);

    public void SetBuffer(int nameID, ComputeBuffer value) => Sheet.SetBuffer(nameID, value?.Storage);

    public void SetConstantBuffer(string name, ComputeBuffer value, int offset, int size) => SetConstantBuffer(ShaderNames.Id(name), value, offset, size);

    public void SetConstantBuffer(int nameID, ComputeBuffer value, int offset, int size) => Sheet.SetConstantBuffer(nameID, new BufferSlot(value?.Storage, offset, size));

    public void SetBuffer(string name, GraphicsBuffer value) => SetBuffer(ShaderNames.Id(name), value);

    public void SetBuffer(int nameID, GraphicsBuffer value) => Sheet.SetBuffer(nameID, value?.Storage);

    public void SetConstantBuffer(string name, GraphicsBuffer value, int offset, int size) => SetConstantBuffer(ShaderNames.Id(name), value, offset, size);

    public void SetConstantBuffer(int nameID, GraphicsBuffer value, int offset, int size) => Sheet.SetConstantBuffer(nameID, new BufferSlot(value?.Storage, offset, size));
}
