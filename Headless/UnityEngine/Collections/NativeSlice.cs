using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Unity.Collections;

/// <summary>A strided view of a NativeArray.</summary>
public unsafe struct NativeSlice<T> : IEnumerable<T>, IEquatable<NativeSlice<T>> where T : struct
{
    internal byte* m_Buffer;
    internal int m_Stride;
    internal int m_Length;
    NativeMemoryHandle? m_Handle;

    public NativeSlice(NativeArray<T> array) : this(array, 0, array.Length) { }
    public NativeSlice(NativeArray<T> array, int start) : this(array, start, array.Length - start) { }

    public NativeSlice(NativeArray<T> array, int start, int length)
    {
        if (start < 0 || length < 0 || (long)start + length > array.Length)
            throw new ArgumentException($"Slice start + length ({(long)start + length}) range must be <= array.Length ({array.Length})");
        array.CheckExists();
        m_Stride = Unsafe.SizeOf<T>();
        m_Buffer = (byte*)array.m_Buffer + (long)start * m_Stride;
        m_Length = length;
        m_Handle = array.m_Handle;
    }

    public int Length => m_Length;
    public int Stride => m_Stride;

    public T this[int index]
    {
        get { CheckIndex(index); return Unsafe.ReadUnaligned<T>(m_Buffer + (long)index * m_Stride); }
        set { CheckIndex(index); Unsafe.WriteUnaligned(m_Buffer + (long)index * m_Stride, value); }
    }

    void CheckIndex(int index)
    {
        if ((uint)index >= (uint)m_Length) throw new IndexOutOfRangeException($"Index {index} is out of range of '{m_Length}' Length.");
        if (m_Handle is { IsReleased: true }) throw new ObjectDisposedException(nameof(NativeSlice<T>), "Attempted to access a NativeSlice whose array has been disposed.");
    }

    public T[] ToArray()
    {
        var array = new T[m_Length];
        CopyTo(array);
        return array;
    }

    public void CopyTo(T[] array)
    {
        if (array.Length != m_Length) throw new ArgumentException($"array.Length ({array.Length}) does not match the Length of this instance ({m_Length}).", nameof(array));
        for (int i = 0; i < m_Length; i++) array[i] = this[i];
    }

    public void CopyFrom(T[] array)
    {
        if (array.Length != m_Length) throw new ArgumentException($"array.Length ({array.Length}) does not match the Length of this instance ({m_Length}).", nameof(array));
        for (int i = 0; i < m_Length; i++) this[i] = array[i];
    }

    public static implicit operator NativeSlice<T>(NativeArray<T> array) => new(array);

    public Enumerator GetEnumerator() => new(ref this);
    IEnumerator<T> IEnumerable<T>.GetEnumerator() => new Enumerator(ref this);
    IEnumerator IEnumerable.GetEnumerator() => new Enumerator(ref this);

    public bool Equals(NativeSlice<T> other) => m_Buffer == other.m_Buffer && m_Stride == other.m_Stride && m_Length == other.m_Length;
    public override bool Equals(object? obj) => obj is NativeSlice<T> other && Equals(other);
    public override int GetHashCode() => HashCode.Combine((IntPtr)m_Buffer, m_Stride, m_Length);
    public static bool operator ==(NativeSlice<T> left, NativeSlice<T> right) => left.Equals(right);
    public static bool operator !=(NativeSlice<T> left, NativeSlice<T> right) => !left.Equals(right);

    public struct Enumerator : IEnumerator<T>
    {
        NativeSlice<T> m_Array;
        int m_Index;

        public Enumerator(ref NativeSlice<T> array)
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
