using Headless.Engine;

namespace UnityEngine.Profiling;

public sealed class CustomSampler : Sampler
{
    CustomSampler(ProfilerMarkerData data) : base(data) { }

    public static CustomSampler Create(string name, bool collectGpuData = false) => new(ProfilerMarkerData.Of(name));

    public void Begin() => Data!.Begin();
    public void Begin(Object targetObject) => Data!.Begin();
    public void End() => Data!.End();
}
