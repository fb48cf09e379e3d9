using System;
using Headless.Engine;
using Unity.Collections;

namespace UnityEngine.Rendering;

public struct AsyncGPUReadbackRequest
{
    private readonly ReadbackState? state;

    internal AsyncGPUReadbackRequest(ReadbackState state) => this.state = state;

    public bool done => state?.Done ?? true;
    public bool hasError => state?.HasError ?? true;
    public int width => state?.Width ?? 0;
    public int height => state?.Height ?? 0;
    public int depth => state?.Depth ?? 0;
    public int layerCount => 1;
    public int layerDataSize => state?.Size ?? 0;
    public bool forcePlayerLoopUpdate { get; set; }

    public void Update() => state?.Poll();

    public void WaitForCompletion() => state?.Wait();

    public NativeArray<T> GetData<T>(int layer = 0)
        where T : struct
    {
        if (layer != 0)
        {
            throw new ArgumentException($"Layer index is out of range {layer} / 1");
        }

        return state is null
            ? throw new InvalidOperationException("Cannot access the data of a request that was never made.")
            : state.Data<T>();
    }
}
