using System;
using Headless.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor;

public sealed class EditorApplication
{
    public delegate void CallbackFunction();

    public static CallbackFunction? update;
    public static CallbackFunction? delayCall;

    public static event Action<PlayModeStateChange>? playModeStateChanged;
    public static event Action? hierarchyChanged;
    public static event Action? projectChanged;
    public static event Action? quitting;

    static EditorApplication() => EngineHooks.EditorUpdate = RunUpdate;

    public static double timeSinceStartup => Time.realtimeSinceStartupAsDouble;
    public static bool isCompiling => false;
    public static bool isUpdating => false;
    public static bool isPaused { get; set; }
    public static bool isPlayingOrWillChangePlaymode => EngineState.IsPlaying;

    public static bool isPlaying
    {
        get => EngineState.IsPlaying;
        set
        {
            if (value) EnterPlaymode();
            else ExitPlaymode();
        }
    }

    /// <summary>Starts the open scene afresh in play mode; a scene that is not a file starts empty.</summary>
    public static void EnterPlaymode()
    {
        if (EngineState.IsPlaying) return;
        playModeStateChanged?.Invoke(PlayModeStateChange.ExitingEditMode);
        string path = SceneManager.GetActiveScene().path;
        SceneTable.DestroyAll();
        PlaySession.Begin(path.Length > 0 ? path : null, EngineState.ScriptAssemblies);
        playModeStateChanged?.Invoke(PlayModeStateChange.EnteredPlayMode);
    }

    public static void ExitPlaymode()
    {
        if (!EngineState.IsPlaying) return;
        playModeStateChanged?.Invoke(PlayModeStateChange.ExitingPlayMode);
        PlaySession.End();
        playModeStateChanged?.Invoke(PlayModeStateChange.EnteredEditMode);
    }

    public static void Exit(int returnValue)
    {
        quitting?.Invoke();
        EngineState.ExitCode = returnValue;
        EngineState.QuitRequested = true;
    }

    public static void QueuePlayerLoopUpdate() { }
    public static void RepaintHierarchyWindow() { }
    public static void Beep() { }

    internal static void SendHierarchyChanged() => hierarchyChanged?.Invoke();
    internal static void SendProjectChanged() => projectChanged?.Invoke();

    internal static void RunUpdate()
    {
        CallbackFunction? delayed = delayCall;
        delayCall = null;
        delayed?.Invoke();
        update?.Invoke();
    }
}
