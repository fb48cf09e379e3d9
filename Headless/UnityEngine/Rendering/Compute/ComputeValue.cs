using System.Linq;
using System;

namespace Headless.Engine;

/// <summary>The bytes set under one name on a compute shader.</summary>
internal sealed class ComputeValue
{
    private byte[] data = [];
    private int length = -1;

    public bool IsSet => length >= 0;
    public ReadOnlySpan<byte> Bytes => data.AsSpan(0, length);

    /// <summary>True when the value is not what it was.</summary>
    public bool Set(ReadOnlySpan<byte> value)
    {
        if (IsSet && Bytes.SequenceEqual(value))
        {
            return false;
        }

        if (data.Length < value.Length)
        {
            data = new byte[value.Length];
        }

        value.CopyTo(data);
        length = value.Length;
        return true;
    }

    public void CopyFrom(ComputeValue other)
    {
        if (other.IsSet)
        {
            Set(other.Bytes);
        }
    }
}
