using System;
using System.IO;
using System.Reflection;

namespace Headless.Engine;

/// <summary>What kind of run this is, and where its files are; set by the host before anything else.</summary>
static class EngineState
{
    public static bool IsPlaying { get; set; }
    public static bool IsEditor { get; set; }
    public static bool IsBatchMode { get; set; } = true;
    public static bool QuitRequested { get; set; }
    public static int ExitCode { get; set; }

    /// <summary>What entering play mode leaves out, as bits of the Editor's EnterPlayModeOptions; null where those options are off.</summary>
    public static int? EnterPlayModeOptions { get; set; }

    /// <summary>Whether the project's scripts, and with them their statics, are new in each play.</summary>
    public static bool ReloadsDomain => (EnterPlayModeOptions & 1) != 1;

    public static string ProjectPath { get; set; } = Directory.GetCurrentDirectory();
    public static string ProductName { get; set; } = "Headless";
    public static string CompanyName { get; set; } = "DefaultCompany";

    /// <summary>Assemblies of the project: [RuntimeInitializeOnLoadMethod] is looked for here.</summary>
    public static Assembly[] ScriptAssemblies { get; set; } = Array.Empty<Assembly>();

    /// <summary>Forgets every scene object, clock and pending call without sending messages; assets stay.</summary>
    public static void Reset()
    {
        foreach (UnityEngine.Object instance in ObjectRegistry.Snapshot())
            if (instance is UnityEngine.GameObject or UnityEngine.Component && !instance.IsPersistent) instance.Kill();
        Destruction.Clear();
        ScriptSchedule.Clear();
        CoroutineScheduler.Clear();
        PlayableGraphs.Clear();
        SceneTable.Clear();
        PhysicsWorld.Clear();
        FrameClock.Reset();
        QuitRequested = false;
        ExitCode = 0;
    }
}
