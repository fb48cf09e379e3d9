using System;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Binds what a kernel reads and records its dispatch, with Unity's checks.</summary>
internal static class ComputeDispatcher
{
    public const int MaxGroups = 65535;

    public static void Dispatch(ComputeShader shader, int kernelIndex, int x, int y, int z)
    {
        if (x <= 0 || y <= 0 || z <= 0)
        {
            Debug.LogError($"{shader.name}: Thread group count must be at least 1 in each dimension, not ({x}, {y}, {z}), at kernel index ({kernelIndex})");
            return;
        }

        if (x > MaxGroups || y > MaxGroups || z > MaxGroups)
        {
            Debug.LogError($"{shader.name}: Thread group count ({x}, {y}, {z}) is above the maximum allowed limit at kernel index ({kernelIndex}). Maximum allowed thread group count is {MaxGroups}");
            return;
        }

        if (Bind(shader, kernelIndex, out ComputeVariant? variant, out GpuComputePipeline? pipeline))
        {
            GraphicsDevice.Recorder.Dispatch(pipeline!, variant!.Bindings, (uint)x, (uint)y, (uint)z);
        }
    }

    public static void DispatchIndirect(ComputeShader shader, int kernelIndex, DeviceBuffer? arguments, uint offset)
    {
        if (arguments is not { IsValid: true })
        {
            Debug.LogError($"{shader.name}: the indirect arguments buffer of kernel index ({kernelIndex}) is null or released");
            return;
        }

        if (offset % 4 != 0 || offset + 12L > arguments.ByteSize)
        {
            Debug.LogError($"{shader.name}: indirect arguments offset {offset} must be a multiple of 4 and leave 12 bytes in a buffer of {arguments.ByteSize} bytes");
            return;
        }

        if (BufferViewCheck.NotArguments(arguments) is { } problem)
        {
            Debug.LogError($"{shader.name}: indirect dispatch of kernel index ({kernelIndex}): {problem}");
            return;
        }

        if (Bind(shader, kernelIndex, out ComputeVariant? variant, out GpuComputePipeline? pipeline))
        {
            GraphicsDevice.Recorder.DispatchIndirect(pipeline!, variant!.Bindings, arguments.Gpu, offset);
        }
    }

    private static bool Bind(ComputeShader shader, int kernelIndex, out ComputeVariant? variant, out GpuComputePipeline? pipeline)
    {
        variant = null;
        pipeline = null;
        ComputeProgram program = shader.Program;
        ComputeKernel? kernel = program.Kernel(kernelIndex);
        if (kernel is null)
        {
            return false;
        }

        variant = program.Variant(kernel);
        if (variant is null)
        {
            Debug.LogError($"Compute shader ({shader.name}): kernel at index ({kernelIndex}) '{kernel.Name}' is invalid");
            return false;
        }

        if (variant.Unsupported is { } reason)
        {
            Debug.LogError($"Compute shader ({shader.name}): kernel at index ({kernelIndex}) '{kernel.Name}' is not supported: {reason}");
            return false;
        }

        ResourceBindings bindings = variant.Bindings;
        Span<(int, ImageFormat)> formats = stackalloc (int, ImageFormat)[8];
        int formatCount = 0;
        if (!BindBuffers(variant.Table, kernel, bindings, out string? missing, out string? mismatch)
            || !BindTextures(variant.Table, kernel, bindings, formats, ref formatCount, out missing))
        {
            Debug.LogError(mismatch is null
                ? $"Compute shader ({shader.name}): Property ({missing}) at kernel index ({kernelIndex}) is not set"
                : $"Compute shader ({shader.name}): kernel '{kernel.Name}' ({kernelIndex}): {mismatch}");
            return false;
        }

        BindBlocks(variant, program.State, bindings);
        foreach (SamplerEntry sampler in variant.Table.Samplers)
        {
            Texture? owner = sampler.TextureId >= 0 ? FindTexture(kernel, sampler.TextureId).Texture : null;
            bindings.SetSampler(variant.Table.Set, sampler.Binding, Samplers.For(sampler, owner));
        }

        pipeline = variant.Pipeline(formats[..formatCount]);
        KernelUse.Add(variant);
        return true;
    }

    private static bool BindBuffers(
        BindingTable table, ComputeKernel kernel, ResourceBindings bindings, out string? missing, out string? mismatch)
    {
        missing = mismatch = null;
        foreach (BufferEntry entry in table.Buffers)
        {
            if (!kernel.Buffers.TryGetValue(entry.NameId, out BufferSlot slot) || !slot.IsSet)
            {
                GlobalProperties.Sheet.Buffers.TryGetValue(entry.NameId, out slot);
            }

            if (!slot.IsSet)
            {
                missing = entry.Name;
                return false;
            }

            mismatch = BufferViewCheck.Mismatch(entry, slot.Buffer!);
            if (mismatch is not null)
            {
                return false;
            }

            bindings.SetBuffer(table.Set, entry.Binding, entry.Of(slot.Buffer!));
        }

        return true;
    }

    private static bool BindTextures(
        BindingTable table, ComputeKernel kernel, ResourceBindings bindings,
        Span<(int, ImageFormat)> formats, ref int formatCount, out string? missing)
    {
        foreach (TextureEntry entry in table.Textures)
        {
            TextureSlot slot = FindTexture(kernel, entry.NameId);
            GpuTexture? texture = slot.Texture is null ? null : slot.Texture.DeviceTexture(slot.Element);
            if (texture is null)
            {
                missing = entry.Name;
                return false;
            }

            if (entry.Storage)
            {
                bindings.SetTexture(table.Set, entry.Binding, texture, slot.MipLevel);
                formats[formatCount++] = (entry.Binding, TextureFormats.StorageFormat(texture.Description.Format));
            }
            else
            {
                bindings.SetTexture(table.Set, entry.Binding, texture);
            }
        }

        missing = null;
        return true;
    }

    private static void BindBlocks(ComputeVariant variant, ComputeState state, ResourceBindings bindings)
    {
        foreach (ComputeBlock block in variant.Blocks)
        {
            int id = block.Entry.NameId;
            if ((state.ConstantBuffers.TryGetValue(id, out BufferSlot slot) || GlobalProperties.Sheet.ConstantBuffers.TryGetValue(id, out slot)) && slot.IsSet)
            {
                bindings.SetBuffer(variant.Table.Set, block.Entry.Binding, slot.Buffer!.Gpu, slot.Offset, slot.Size > 0 ? slot.Size : -1);
            }
            else
            {
                bindings.SetUniform(variant.Table.Set, block.Entry.Binding, block.Pack(state));
            }
        }
    }

    private static TextureSlot FindTexture(ComputeKernel kernel, int id)
    {
        if (kernel.Textures.TryGetValue(id, out TextureSlot slot) && slot.Texture != null)
        {
            return slot;
        }

        int globalId = kernel.GlobalTextures.GetValueOrDefault(id, id);
        return GlobalProperties.Sheet.Textures.GetValueOrDefault(globalId);
    }
}
