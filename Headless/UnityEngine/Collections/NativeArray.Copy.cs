using System;
using System.Collections;
using System.Collections.Generic;

namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    public static void Copy(NativeArray<T> src, NativeArray<T> dst) { CheckLengths(src.Length, dst.Length); src.AsReadOnlySpan().CopyTo(dst.AsSpan()); }
    public static void Copy(T[] src, NativeArray<T> dst) { CheckLengths(src.Length, dst.Length); src.AsSpan().CopyTo(dst.AsSpan()); }
    public static void Copy(NativeArray<T> src, T[] dst) { CheckLengths(src.Length, dst.Length); src.AsReadOnlySpan().CopyTo(dst); }
    public static void Copy(ReadOnly src, NativeArray<T> dst) { CheckLengths(src.Length, dst.Length); src.AsReadOnlySpan().CopyTo(dst.AsSpan()); }
    public static void Copy(ReadOnly src, T[] dst) { CheckLengths(src.Length, dst.Length); src.AsReadOnlySpan().CopyTo(dst); }
    public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(T[] src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);
    public static void Copy(NativeArray<T> src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
        src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(dst.AsSpan().Slice(dstIndex, length));

    public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
        src.AsSpan(srcIndex, length).CopyTo(dst.AsSpan().Slice(dstIndex, length));

    public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length) =>
        src.AsReadOnlySpan().Slice(srcIndex, length).CopyTo(dst.AsSpan(dstIndex, length));

    static void CheckLengths(int source, int target)
    {
        if (source != target) throw new ArgumentException("source and destination length must be the same");
    }

    public struct ReadOnly : IEnumerable<T>
    {
        NativeArray<T> m_Array;

        internal ReadOnly(NativeArray<T> array) => m_Array = array;

        public int Length => m_Array.Length;
        public bool IsCreated => m_Array.IsCreated;
        public T this[int index] => m_Array[index];
        public T[] ToArray() => m_Array.ToArray();
        public void CopyTo(T[] array) => m_Array.CopyTo(array);
        public void CopyTo(NativeArray<T> array) => m_Array.CopyTo(array);
        public ReadOnlySpan<T> AsReadOnlySpan() => m_Array.AsReadOnlySpan();
        IEnumerator<T> IEnumerable<T>.GetEnumerator() => m_Array.GetEnumerator();
        IEnumerator IEnumerable.GetEnumerator() => m_Array.GetEnumerator();
        internal readonly NativeArray<T> Array => m_Array;
    }
}
