using System;

namespace Headless.Engine;

/// <summary>Checks on the part of a buffer that is bound as a constant buffer.</summary>
internal static class ConstantRanges
{
    public static void Check(DeviceBuffer buffer, int offset, int size, string owner)
    {
        if (offset < 0 || size <= 0 || offset + (long)size > buffer.ByteSize)
        {
            throw new ArgumentException(
                $"Constant buffer '{buffer.Name}' of {buffer.ByteSize} bytes can't be bound to '{owner}' from byte {offset} with {size} bytes.");
        }

        if (offset % 256 != 0)
        {
            throw new ArgumentException(
                $"Constant buffer '{buffer.Name}' must be bound to '{owner}' at a multiple of 256 bytes, not at {offset}.");
        }
    }
}
