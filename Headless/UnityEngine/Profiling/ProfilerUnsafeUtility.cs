using System;
using Headless.Engine;

namespace Unity.Profiling.LowLevel.Unsafe;

/// <summary>Counter values: memory that scripts write and the frame's end takes. Whole numbers only; the handle of a counter is the address of its value.</summary>
public static class ProfilerUnsafeUtility
{
    public static unsafe void* CreateCounterValue(out IntPtr counterPtr, string name, ushort categoryId, MarkerFlags flags, byte dataType, byte dataUnit, int dataSize,
        ProfilerCounterOptions counterOptions)
    {
        var type = (ProfilerMarkerDataType)dataType;
        if (type is not (ProfilerMarkerDataType.Int32 or ProfilerMarkerDataType.UInt32 or ProfilerMarkerDataType.Int64 or ProfilerMarkerDataType.UInt64))
            throw new NotSupportedException($"The counter '{name}' is of the type {type}; counters of whole numbers are read here.");
        int size = type is ProfilerMarkerDataType.Int32 or ProfilerMarkerDataType.UInt32 ? sizeof(int) : sizeof(long);
        if (dataSize != size) throw new ArgumentException($"The counter '{name}' of the type {type} has {size} bytes, not {dataSize}.", nameof(dataSize));
        ProfilerCounterValue value = ProfilerCounterValue.Create(name, type, (ProfilerMarkerDataUnit)dataUnit, counterOptions);
        counterPtr = (IntPtr)value.Pointer;
        return value.Pointer;
    }

    public static unsafe void FlushCounterValue(void* counterValuePtr) => ProfilerCounterValue.At((IntPtr)counterValuePtr)?.Flush();
}
