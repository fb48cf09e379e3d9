using System;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Fills the bindings of a draw's stages.</summary>
internal static class StageBinder
{
    private const int PixelSet = 2;

    private static byte[] scratch = new byte[1024];

    /// <summary>False after naming what is missing, or what of a buffer does not fit.</summary>
    public static bool Bind(BindingTable table, in PropertyChain chain, ResourceBindings bindings, out string? problem)
    {
        foreach (BufferEntry entry in table.Buffers)
        {
            DeviceBuffer? buffer = WriteTarget(table, entry) ?? (chain.Buffer(entry.NameId) is { IsSet: true } slot ? slot.Buffer : null);
            if (buffer is null)
            {
                problem = Missing(entry.Name);
                return false;
            }

            problem = BufferViewCheck.Mismatch(entry, buffer);
            if (problem is not null)
            {
                return false;
            }

            bindings.SetBuffer(table.Set, entry.Binding, entry.Of(buffer));
        }

        foreach (TextureEntry entry in table.Textures)
        {
            if (!BindTexture(table, entry, chain, bindings))
            {
                problem = Missing(entry.Name);
                return false;
            }
        }

        foreach (SamplerEntry entry in table.Samplers)
        {
            Texture? owner = entry.TextureId >= 0 ? chain.Texture(entry.TextureId).Texture : null;
            bindings.SetSampler(table.Set, entry.Binding, Samplers.For(entry, owner));
        }

        foreach (BlockEntry block in table.Blocks)
        {
            BindBlock(table, block, chain, bindings);
        }

        problem = null;
        return true;
    }

    private static string Missing(string name) =>
        $"requires a buffer \"{name}\" to be bound, but none provided. Skipping draw calls to avoid crashing.";

    /// <summary>What Graphics.SetRandomWriteTarget bound to the register of the buffer; a counter goes with its buffer.</summary>
    private static DeviceBuffer? WriteTarget(BindingTable table, in BufferEntry entry)
    {
        if (table.Set != PixelSet)
        {
            return null;
        }

        int register = entry.Register;
        if (entry.IsCounter)
        {
            int id = entry.NameId;
            register = Array.Find(table.Buffers, b => b.NameId == id && !b.IsCounter).Register;
        }

        return RandomWriteTargets.Buffer(register);
    }

    private static bool BindTexture(BindingTable table, in TextureEntry entry, in PropertyChain chain, ResourceBindings bindings)
    {
        Texture? written = table.Set == PixelSet ? RandomWriteTargets.Texture(entry.Register) : null;
        TextureSlot slot = written is null ? chain.Texture(entry.NameId) : new TextureSlot(written);
        GpuTexture? texture = slot.Texture?.DeviceTexture(slot.Element);
        if (entry.Storage)
        {
            if (texture is null)
            {
                return false;
            }

            bindings.SetTexture(table.Set, entry.Binding, texture, slot.MipLevel);
            return true;
        }

        bool fits = texture is not null && DimensionOf(texture) == entry.Dimension;
        if (!fits)
        {
            UnsetProperties.Note(entry.NameId);
        }

        bindings.SetTexture(table.Set, entry.Binding, fits ? texture! : DefaultTextures.Empty(entry.Dimension));
        return true;
    }

    private static string DimensionOf(GpuTexture texture) => texture.Description.Dimension switch
    {
        GpuTextureDimension.Texture3D => "3D",
        GpuTextureDimension.Cube => "Cube",
        GpuTextureDimension.Texture2DArray => "2DArray",
        _ => "2D",
    };

    private static void BindBlock(BindingTable table, BlockEntry block, in PropertyChain chain, ResourceBindings bindings)
    {
        BufferSlot slot = chain.ConstantBuffer(block.NameId);
        if (slot.IsSet)
        {
            bindings.SetBuffer(table.Set, block.Binding, slot.Buffer!.Gpu, slot.Offset, slot.Size > 0 ? slot.Size : -1);
            return;
        }

        if (scratch.Length < block.Size)
        {
            scratch = new byte[block.Size];
        }

        Span<byte> bytes = scratch.AsSpan(0, block.Size);
        bytes.Clear();
        foreach (MemberEntry member in block.Members)
        {
            if (chain.Value(member.NameId) is { } value)
            {
                ConstantPacker.Write(bytes, member.Constant, value);
            }
            else if (member.TexelSizeOf >= 0)
            {
                var size = new ShaderValue();
                size.Set(chain.TexelSize(member.TexelSizeOf), ShaderValueKind.Vector);
                ConstantPacker.Write(bytes, member.Constant, size);
            }
            else if (member.Constant.IsRead)
            {
                UnsetProperties.Note(member.NameId);
            }
        }

        bindings.SetUniform(table.Set, block.Binding, bytes);
    }
}
