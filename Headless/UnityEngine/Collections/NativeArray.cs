using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Collections;

/// <summary>Unmanaged memory of blittable elements. Use after Dispose and indices out of range throw, as with Unity's safety checks.</summary>
public unsafe partial struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>> where T : struct
{
    internal void* m_Buffer;
    internal int m_Length;
    internal Allocator m_Allocator;
    internal NativeMemoryHandle? m_Handle;

    public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
    {
        if (allocator <= Allocator.None) throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", nameof(allocator));
        ArgumentOutOfRangeException.ThrowIfNegative(length);
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
            throw new InvalidOperationException($"{typeof(T)} used in NativeArray<{typeof(T)}> must be unmanaged (contain no managed types).");
        long bytes = (long)length * Unsafe.SizeOf<T>();
        m_Buffer = UnsafeUtility.Malloc(bytes, 16, allocator);
        if (options == NativeArrayOptions.ClearMemory) UnsafeUtility.MemClear(m_Buffer, bytes);
        m_Length = length;
        m_Allocator = allocator;
        m_Handle = new NativeMemoryHandle();
    }

    public NativeArray(T[] array, Allocator allocator) : this((array ?? throw new ArgumentNullException(nameof(array))).Length, allocator, NativeArrayOptions.UninitializedMemory) =>
        Copy(array, this);

    public NativeArray(NativeArray<T> array, Allocator allocator) : this(array.Length, allocator, NativeArrayOptions.UninitializedMemory) => Copy(array, this);

    public int Length => m_Length;
    public bool IsCreated => m_Buffer != null && m_Handle is not { IsReleased: true };

    public T this[int index]
    {
        get { CheckIndex(index); return Unsafe.ReadUnaligned<T>((byte*)m_Buffer + (long)index * Unsafe.SizeOf<T>()); }
        set { CheckIndex(index); Unsafe.WriteUnaligned((byte*)m_Buffer + (long)index * Unsafe.SizeOf<T>(), value); }
    }

    public void Dispose()
    {
        if (m_Buffer == null || m_Allocator == Allocator.Invalid)
            throw new ObjectDisposedException(nameof(NativeArray<T>), "The NativeArray is already disposed or was never allocated.");
        if (m_Allocator == Allocator.None)
        {
            throw new InvalidOperationException("The NativeArray can not be Disposed because it was not allocated with a valid allocator.");
        }
        CheckExists();
        m_Handle?.Release();
        UnsafeUtility.Free(m_Buffer, m_Allocator);
        m_Buffer = null;
        m_Allocator = Allocator.Invalid;
        m_Length = 0;
    }

    public Span<T> AsSpan() { CheckExists(); return new Span<T>(m_Buffer, m_Length); }
    public ReadOnlySpan<T> AsReadOnlySpan() { CheckExists(); return new ReadOnlySpan<T>(m_Buffer, m_Length); }
    public ReadOnly AsReadOnly() => new(this);

    public T[] ToArray() => AsReadOnlySpan().ToArray();
    public void CopyFrom(T[] array) => Copy(array, this);
    public void CopyFrom(NativeArray<T> array) => Copy(array, this);
    public void CopyTo(T[] array) => Copy(this, array);
    public void CopyTo(NativeArray<T> array) => Copy(this, array);

    public NativeArray<T> GetSubArray(int start, int length)
    {
        CheckExists();
        if (start < 0 || length < 0 || (long)start + length > m_Length)
            throw new ArgumentOutOfRangeException(nameof(length), $"sub array range {start}-{(long)start + length - 1} is outside the range of the native array 0-{m_Length - 1}");
        return new NativeArray<T> { m_Buffer = (byte*)m_Buffer + (long)start * Unsafe.SizeOf<T>(), m_Length = length, m_Allocator = Allocator.None, m_Handle = m_Handle };
    }

    public NativeArray<U> Reinterpret<U>() where U : struct
    {
        if (Unsafe.SizeOf<U>() != Unsafe.SizeOf<T>()) throw new InvalidOperationException($"Types {typeof(T)} and {typeof(U)} are different sizes - direct reinterpretation is not possible.");
        return Reinterpret<U>(Unsafe.SizeOf<T>());
    }

    public NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
    {
        CheckExists();
        if (expectedTypeSize != Unsafe.SizeOf<T>()) throw new InvalidOperationException($"Type {typeof(T)} was expected to be {expectedTypeSize} but is {Unsafe.SizeOf<T>()} bytes");
        long bytes = (long)m_Length * Unsafe.SizeOf<T>();
        if (bytes % Unsafe.SizeOf<U>() != 0) throw new InvalidOperationException($"Types {typeof(T)} (array length {m_Length}) and {typeof(U)} cannot be aliased due to size constraints.");
        return new NativeArray<U> { m_Buffer = m_Buffer, m_Length = (int)(bytes / Unsafe.SizeOf<U>()), m_Allocator = m_Allocator, m_Handle = m_Handle };
    }

    internal void CheckExists()
    {
        if (m_Buffer == null && m_Length == 0 && m_Allocator == Allocator.Invalid && m_Handle is null) return;
        if (m_Handle is { IsReleased: true })
            throw new ObjectDisposedException(nameof(NativeArray<T>), "Attempted to access a NativeArray which has been disposed.");
    }

    void CheckIndex(int index)
    {
        if ((uint)index >= (uint)m_Length)
            throw new IndexOutOfRangeException($"Index {index} is out of range of '{m_Length}' Length.");
        CheckExists();
    }

    public Enumerator GetEnumerator() => new(ref this);
    IEnumerator<T> IEnumerable<T>.GetEnumerator() => new Enumerator(ref this);
    IEnumerator IEnumerable.GetEnumerator() => new Enumerator(ref this);

    public bool Equals(NativeArray<T> other) => m_Buffer == other.m_Buffer && m_Length == other.m_Length;
    public override bool Equals(object? obj) => obj is NativeArray<T> other && Equals(other);
    public override int GetHashCode() => ((IntPtr)m_Buffer).GetHashCode() * 397 ^ m_Length;
    public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);
    public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

    public struct Enumerator : IEnumerator<T>
    {
        NativeArray<T> m_Array;
        int m_Index;

        public Enumerator(ref NativeArray<T> array)
        {
            m_Array = array;
            m_Index = -1;
        }

        public T Current => m_Array[m_Index];
        object IEnumerator.Current => Current;
        public bool MoveNext() => ++m_Index < m_Array.Length;
        public void Reset() => m_Index = -1;
        public void Dispose() { }
    }
}
