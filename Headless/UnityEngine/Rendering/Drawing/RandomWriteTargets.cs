using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What pixel shaders write besides their targets, by register(un): Graphics.SetRandomWriteTarget.</summary>
internal static class RandomWriteTargets
{
    private const int Count = 8;

    private static readonly DeviceBuffer?[] Buffers = new DeviceBuffer?[Count];
    private static readonly Texture?[] Textures = new Texture?[Count];

    public static DeviceBuffer? Buffer(int register) =>
        (uint)register < Count && Buffers[register] is { IsValid: true } buffer ? buffer : null;

    public static Texture? Texture(int register) => (uint)register < Count && Textures[register] != null ? Textures[register] : null;

    /// <param name="preserveCounter">False sets the buffer's hidden counter, if it has one, to 0.</param>
    public static void Set(int index, DeviceBuffer buffer, bool preserveCounter)
    {
        CheckIndex(index);
        (Buffers[index], Textures[index]) = (buffer, null);
        if (!preserveCounter && buffer.Counter is { } counter)
        {
            BufferCounter.Set(counter, 0);
        }
    }

    public static void Set(int index, Texture? texture)
    {
        CheckIndex(index);
        (Buffers[index], Textures[index]) = (null, texture);
    }

    public static void CheckIndex(int index)
    {
        if ((uint)index >= Count)
        {
            throw new ArgumentOutOfRangeException(nameof(index), $"SetRandomWriteTarget: index {index} is not from 0 to {Count - 1}.");
        }
    }

    public static void Clear()
    {
        Array.Clear(Buffers);
        Array.Clear(Textures);
    }
}
