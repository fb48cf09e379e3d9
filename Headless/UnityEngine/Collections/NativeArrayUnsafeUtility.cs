namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe class NativeArrayUnsafeUtility
{
    public static void* GetUnsafePtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckExists();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckExists();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T>.ReadOnly nativeArray) where T : struct => nativeArray.Array.GetUnsafeReadOnlyPtr();

    public static void* GetUnsafeBufferPointerWithoutChecks<T>(NativeArray<T> nativeArray) where T : struct => nativeArray.m_Buffer;

    public static NativeArray<T> ConvertExistingDataToNativeArray<T>(void* dataPointer, int length, Allocator allocator) where T : struct =>
        new() { m_Buffer = dataPointer, m_Length = length, m_Allocator = allocator };
}
