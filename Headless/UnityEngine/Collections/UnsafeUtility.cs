using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe class UnsafeUtility
{
    public static void* Malloc(long size, int alignment, Allocator allocator)
    {
        void* memory = NativeMemory.AlignedAlloc((nuint)Math.Max(size, 1), (nuint)Math.Max(alignment, sizeof(void*)));
        if (Headless.Engine.MemoryPoison.Enabled)
        {
            NativeMemory.Fill(memory, (nuint)Math.Max(size, 1), 0xFF);
        }

        return memory;
    }

    public static void Free(void* memory, Allocator allocator) => NativeMemory.AlignedFree(memory);

    public static void MemCpy(void* destination, void* source, long size) => NativeMemory.Copy(source, destination, (nuint)size);
    public static void MemMove(void* destination, void* source, long size) => Buffer.MemoryCopy(source, destination, size, size);
    public static void MemClear(void* destination, long size) => NativeMemory.Clear(destination, (nuint)size);
    public static void MemSet(void* destination, byte value, long size) => NativeMemory.Fill(destination, (nuint)size, value);

    public static int MemCmp(void* ptr1, void* ptr2, long size)
    {
        byte* a = (byte*)ptr1, b = (byte*)ptr2;
        for (long i = 0; i < size; i++)
            if (a[i] != b[i]) return a[i] - b[i];
        return 0;
    }

    public static int SizeOf<T>() where T : struct => System.Runtime.CompilerServices.Unsafe.SizeOf<T>();
    public static int AlignOf<T>() where T : struct => System.Runtime.CompilerServices.Unsafe.SizeOf<AlignOfHelper<T>>() - SizeOf<T>();
    public static void* AddressOf<T>(ref T output) where T : struct => System.Runtime.CompilerServices.Unsafe.AsPointer(ref output);
    public static ref T AsRef<T>(void* ptr) where T : struct => ref System.Runtime.CompilerServices.Unsafe.AsRef<T>(ptr);
    public static ref T As<U, T>(ref U from) => ref System.Runtime.CompilerServices.Unsafe.As<U, T>(ref from);

    public static bool IsUnmanaged<T>() => !RuntimeHelpers.IsReferenceOrContainsReferences<T>();
    public static bool IsBlittable<T>() where T : struct => IsUnmanaged<T>();

    struct AlignOfHelper<T> where T : struct
    {
        public byte dummy;
        public T data;
    }
}
