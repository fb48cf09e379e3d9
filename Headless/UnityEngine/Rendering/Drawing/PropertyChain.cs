using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Looks properties up as a draw sees them: block, material, shader defaults, per-draw values, globals.</summary>
internal readonly ref struct PropertyChain(PropertySheet? block, Material material, ShaderProgramSet programs, PropertySheet perDraw)
{
    public ShaderValue? Value(int id)
    {
        if (block is not null && block.Values.TryGetValue(id, out ShaderValue? value))
        {
            return value;
        }

        return material.Sheet.Values.TryGetValue(id, out value)
            || programs.Defaults.Values.TryGetValue(id, out value)
            || perDraw.Values.TryGetValue(id, out value)
            || GlobalProperties.Sheet.Values.TryGetValue(id, out value)
            ? value
            : null;
    }

    public BufferSlot Buffer(int id)
    {
        if (block is not null && block.Buffers.TryGetValue(id, out BufferSlot slot) && slot.IsSet)
        {
            return slot;
        }

        return material.Sheet.Buffers.TryGetValue(id, out slot) && slot.IsSet
            ? slot
            : GlobalProperties.Sheet.Buffers.GetValueOrDefault(id);
    }

    public BufferSlot ConstantBuffer(int id)
    {
        if (block is not null && block.ConstantBuffers.TryGetValue(id, out BufferSlot slot))
        {
            return slot;
        }

        return material.Sheet.ConstantBuffers.TryGetValue(id, out slot) ? slot : GlobalProperties.Sheet.ConstantBuffers.GetValueOrDefault(id);
    }

    /// <summary>The texture; null when none is set and the property has no default.</summary>
    public TextureSlot Texture(int id)
    {
        if (block is not null && block.Textures.TryGetValue(id, out TextureSlot slot) && slot.Texture != null)
        {
            return slot;
        }

        if (material.Sheet.Textures.TryGetValue(id, out slot) && slot.Texture != null)
        {
            return slot;
        }

        if (programs.TextureDefaults.TryGetValue(id, out string? name) && (name.Length > 0 || !GlobalProperties.Sheet.Textures.ContainsKey(id)))
        {
            return new TextureSlot(DefaultTextures.Named(name));
        }

        slot = GlobalProperties.Sheet.Textures.GetValueOrDefault(id);
        return slot.Texture != null ? slot : default;
    }

    public Vector4 TexelSize(int textureId)
    {
        if (Texture(textureId).Texture is not { } texture)
        {
            return new Vector4(1f, 1f, 1f, 1f);
        }

        return new Vector4(1f / texture.width, 1f / texture.height, texture.width, texture.height);
    }
}
