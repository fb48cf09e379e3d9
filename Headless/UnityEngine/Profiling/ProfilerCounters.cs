using System;
using System.Collections.Concurrent;

namespace Headless.Engine;

/// <summary>Named counters that ProfilerRecorder can read besides markers.</summary>
static class ProfilerCounters
{
    static readonly ConcurrentDictionary<string, Func<long>> s_Counters = new(StringComparer.Ordinal)
    {
        ["GC Used Memory"] = static () => GC.GetTotalMemory(false),
        ["System Used Memory"] = static () => Environment.WorkingSet,
        ["Main Thread"] = static () => (long)(FrameClock.UnscaledDeltaTime * 1e9),
    };

    public static void Set(string name, Func<long> read) => s_Counters[name] = read;
    public static bool Has(string name) => s_Counters.ContainsKey(name);
    public static long Read(string name) => s_Counters.TryGetValue(name, out Func<long>? read) ? read() : 0;
}
