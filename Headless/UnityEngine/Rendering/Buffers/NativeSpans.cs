using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System;
using Unity.Collections;

namespace Headless.Engine;

/// <summary>Spans over native arrays.</summary>
internal static class NativeSpans
{
    public static ReadOnlySpan<T> Read<T>(NativeArray<T> array)
        where T : struct => array.AsReadOnlySpan();

    public static Span<T> Write<T>(NativeArray<T> array)
        where T : struct => array.AsSpan();

    public static int SizeOf<T>() => Unsafe.SizeOf<T>();

    public static ReadOnlySpan<byte> Bytes<T>(NativeArray<T> array)
        where T : struct => BytesOf(Read(array));

    public static Span<byte> WriteBytes<T>(NativeArray<T> array)
        where T : struct
    {
        Span<T> span = Write(array);
        return MemoryMarshal.CreateSpan(ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(span)), checked(span.Length * Unsafe.SizeOf<T>()));
    }

    public static ReadOnlySpan<byte> BytesOf<T>(ReadOnlySpan<T> span)
        where T : struct =>
        MemoryMarshal.CreateReadOnlySpan(ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(span)), checked(span.Length * Unsafe.SizeOf<T>()));
}
