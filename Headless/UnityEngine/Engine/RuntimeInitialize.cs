using UnityEngine;

namespace Headless.Engine;

/// <summary>[RuntimeInitializeOnLoadMethod]: when a play begins.</summary>
static class RuntimeInitialize
{
    public static void Run(RuntimeInitializeLoadType loadType) => StaticMethods.Call<RuntimeInitializeOnLoadMethodAttribute>(a => a.loadType == loadType);
}
