using System;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Collections;

/// <summary>Memory of arrays that the engine hands out: it lives as long as a copy of the array does, and scripts do not dispose of it.</summary>
sealed unsafe class NativeMemoryOwner : NativeMemoryHandle
{
    private readonly void* memory;

    private NativeMemoryOwner(void* memory) => this.memory = memory;

    ~NativeMemoryOwner() => UnsafeUtility.Free(memory, Allocator.Persistent);

    public static NativeArray<T> Array<T>(ReadOnlySpan<T> values)
        where T : unmanaged
    {
        void* memory = UnsafeUtility.Malloc((long)values.Length * sizeof(T), 16, Allocator.Persistent);
        values.CopyTo(new Span<T>(memory, values.Length));
        return new NativeArray<T> { m_Buffer = memory, m_Length = values.Length, m_Allocator = Allocator.None, m_Handle = new NativeMemoryOwner(memory) };
    }
}
