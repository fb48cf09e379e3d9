using System;
using System.Collections.Concurrent;
using System.Threading;
using UnityEngine;

namespace Unity.Profiling;

public readonly struct ProfilerCategory
{
    static readonly ConcurrentDictionary<string, ushort> s_Ids = new(StringComparer.Ordinal);
    static int s_LastId;

    readonly string? m_Name;

    public ProfilerCategory(string categoryName) => m_Name = categoryName;

    public string Name => m_Name ?? "Other";
    public Color32 Color => new(128, 128, 128, 255);

    public static ProfilerCategory Render => new("Render");
    public static ProfilerCategory Scripts => new("Scripts");
    public static ProfilerCategory Gui => new("GUI");
    public static ProfilerCategory Physics => new("Physics");
    public static ProfilerCategory Animation => new("Animation");
    public static ProfilerCategory Ai => new("AI");
    public static ProfilerCategory Audio => new("Audio");
    public static ProfilerCategory Video => new("Video");
    public static ProfilerCategory Particles => new("Particles");
    public static ProfilerCategory Lighting => new("Lighting");
    public static ProfilerCategory Network => new("Network");
    public static ProfilerCategory Loading => new("Loading");
    public static ProfilerCategory Memory => new("Memory");
    public static ProfilerCategory Input => new("Input");
    public static ProfilerCategory Internal => new("Internal");
    public static ProfilerCategory FileIO => new("File IO");

    public override string ToString() => Name;

    public static implicit operator ushort(ProfilerCategory category) => s_Ids.GetOrAdd(category.Name, static _ => (ushort)Interlocked.Increment(ref s_LastId));
}
