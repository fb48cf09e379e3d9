using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine.Profiling;

public class Sampler
{
    internal Sampler(ProfilerMarkerData? data) => Data = data;

    internal ProfilerMarkerData? Data { get; }

    public bool isValid => Data is not null;
    public string name => Data?.Name!;

    public Recorder GetRecorder() => new(Data);

    public static Sampler Get(string name) => new(ProfilerMarkerData.Find(name));

    public static int GetNames(List<string> names)
    {
        ICollection<ProfilerMarkerData> all = ProfilerMarkerData.All;
        if (names is not null)
        {
            names.Clear();
            foreach (ProfilerMarkerData data in all) names.Add(data.Name);
        }
        return all.Count;
    }
}
