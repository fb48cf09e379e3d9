using System.Collections.Generic;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

static class InitializeSample
{
    public static List<string> Calls { get; } = new();

    [RuntimeInitializeOnLoadMethod] static void After() => Calls.Add("after");
    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)] static void Before() => Calls.Add("before");
    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSplashScreen)] static void Splash() => Calls.Add("splash");
    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.AfterAssembliesLoaded)] static void Assemblies() => Calls.Add("assemblies");
    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)] static void Subsystem() => Calls.Add("subsystem");
}
