using System;
using System.Collections.Concurrent;
using System.Runtime.InteropServices;
using Unity.Profiling;
using Unity.Profiling.LowLevel;

namespace Headless.Engine;

/// <summary>A counter that scripts write. It lives as long as the program; a second one of the same name is the first.</summary>
sealed unsafe class ProfilerCounterValue
{
    static readonly ConcurrentDictionary<string, ProfilerCounterValue> s_ByName = new(StringComparer.Ordinal);

    readonly ProfilerMarkerDataType m_Type;
    readonly ProfilerCounterOptions m_Options;
    long m_Flushed;

    ProfilerCounterValue(ProfilerMarkerDataType type, ProfilerMarkerDataUnit unit, ProfilerCounterOptions options)
    {
        (m_Type, Unit, m_Options) = (type, unit, options);
        Pointer = NativeMemory.AllocZeroed(sizeof(long));
    }

    public void* Pointer { get; }
    public ProfilerMarkerDataUnit Unit { get; }

    public static ProfilerCounterValue Create(string name, ProfilerMarkerDataType type, ProfilerMarkerDataUnit unit, ProfilerCounterOptions options) =>
        s_ByName.GetOrAdd(name, n =>
        {
            var value = new ProfilerCounterValue(type, unit, options);
            ProfilerCounters.Set(n, () => value.m_Flushed);
            return value;
        });

    public static ProfilerCounterValue? Find(string name) => s_ByName.GetValueOrDefault(name);

    public static ProfilerCounterValue? At(IntPtr pointer)
    {
        foreach (ProfilerCounterValue value in s_ByName.Values)
            if ((IntPtr)value.Pointer == pointer) return value;
        return null;
    }

    public static void EndFrame()
    {
        foreach (ProfilerCounterValue value in s_ByName.Values)
            if ((value.m_Options & ProfilerCounterOptions.FlushOnEndOfFrame) != 0) value.Flush();
    }

    public void Flush()
    {
        m_Flushed = m_Type switch
        {
            ProfilerMarkerDataType.Int32 => *(int*)Pointer,
            ProfilerMarkerDataType.UInt32 => *(uint*)Pointer,
            _ => *(long*)Pointer,
        };
        if ((m_Options & ProfilerCounterOptions.ResetToZeroOnFlush) != 0) *(long*)Pointer = 0;
    }
}
