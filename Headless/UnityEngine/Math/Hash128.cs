using System;
using System.Collections.Generic;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using Unity.Collections;

namespace UnityEngine;

/// <summary>128-bit value; Compute and Append mix with two chained 64-bit FNV-1a streams (not Unity's own numbers).</summary>
[Serializable]
[StructLayout(LayoutKind.Sequential)]
public struct Hash128 : IComparable, IComparable<Hash128>, IEquatable<Hash128>
{
    ulong m_Low;
    ulong m_High;

    public Hash128(uint u32_0, uint u32_1, uint u32_2, uint u32_3)
    {
        m_Low = ((ulong)u32_1 << 32) | u32_0;
        m_High = ((ulong)u32_3 << 32) | u32_2;
    }

    public Hash128(ulong u64_0, ulong u64_1) { m_Low = u64_0; m_High = u64_1; }

    public bool isValid => m_Low != 0 || m_High != 0;

    public static Hash128 Parse(string hashString)
    {
        if (hashString is not { Length: 32 }) return default;
        Span<byte> bytes = stackalloc byte[16];
        for (int i = 0; i < 16; i++)
            if (!byte.TryParse(hashString.AsSpan(i * 2, 2), NumberStyles.HexNumber, CultureInfo.InvariantCulture, out bytes[i])) return default;
        return new Hash128(MemoryMarshal.Read<ulong>(bytes), MemoryMarshal.Read<ulong>(bytes[8..]));
    }

    public static Hash128 Compute(string data) { var h = default(Hash128); h.Append(data); return h; }
    public static Hash128 Compute(int val) { var h = default(Hash128); h.Append(val); return h; }
    public static Hash128 Compute(float val) { var h = default(Hash128); h.Append(val); return h; }
    public static Hash128 Compute<T>(ref T val) where T : unmanaged { var h = default(Hash128); h.Append(ref val); return h; }
    public static Hash128 Compute<T>(T[] data) where T : struct { var h = default(Hash128); h.Append(data); return h; }
    public static Hash128 Compute<T>(NativeArray<T> data) where T : struct { var h = default(Hash128); h.Append(data); return h; }
    public static Hash128 Compute<T>(List<T> data) where T : struct { var h = default(Hash128); h.Append(data); return h; }

    public void Append(string data) => AppendBytes(MemoryMarshal.AsBytes(data.AsSpan()));
    public void Append(int val) => AppendBytes(MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref val, 1)));
    public void Append(float val) => AppendBytes(MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref val, 1)));
    public void Append<T>(ref T val) where T : unmanaged => AppendBytes(MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref val, 1)));
    public void Append<T>(T[] data) where T : struct => AppendBytes(MemoryMarshal.AsBytes(data.AsSpan()));
    public void Append<T>(NativeArray<T> data) where T : struct => AppendBytes(MemoryMarshal.AsBytes(data.AsReadOnlySpan()));
    public void Append<T>(List<T> data) where T : struct => AppendBytes(MemoryMarshal.AsBytes(CollectionsMarshal.AsSpan(data)));

    void AppendBytes(ReadOnlySpan<byte> bytes)
    {
        const ulong prime = 0x00000100000001B3UL;
        ulong low = m_Low ^ 0xCBF29CE484222325UL, high = m_High ^ 0x84222325CBF29CE4UL;
        foreach (byte b in bytes)
        {
            low = (low ^ b) * prime;
            high = (high ^ b ^ (low >> 29)) * prime;
        }
        m_Low = low ^ (ulong)bytes.Length;
        m_High = high;
    }

    public int CompareTo(Hash128 rhs) => m_High != rhs.m_High ? m_High.CompareTo(rhs.m_High) : m_Low.CompareTo(rhs.m_Low);
    public int CompareTo(object? obj) => obj is Hash128 h ? CompareTo(h) : 1;
    public readonly bool Equals(Hash128 obj) => m_Low == obj.m_Low && m_High == obj.m_High;
    public override readonly bool Equals(object? obj) => obj is Hash128 h && Equals(h);
    public override readonly int GetHashCode() => HashCode.Combine(m_Low, m_High);

    public override string ToString()
    {
        Span<byte> bytes = stackalloc byte[16];
        MemoryMarshal.Write(bytes, in m_Low);
        MemoryMarshal.Write(bytes[8..], in m_High);
        return Convert.ToHexStringLower(bytes);
    }

    public static bool operator ==(Hash128 hash1, Hash128 hash2) => hash1.Equals(hash2);
    public static bool operator !=(Hash128 hash1, Hash128 hash2) => !hash1.Equals(hash2);
    public static bool operator <(Hash128 x, Hash128 y) => x.CompareTo(y) < 0;
    public static bool operator >(Hash128 x, Hash128 y) => x.CompareTo(y) > 0;
}
