using System;
using Headless.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor;

public sealed class EditorApplication
{
    public delegate void CallbackFunction();

    static string s_OpenScene = "";

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
        s_OpenScene = SceneManager.GetActiveScene().path;
        SceneTable.DestroyAll();
        PlaySession.Begin(s_OpenScene.Length > 0 ? s_OpenScene : null, EngineState.ScriptAssemblies);
        playModeStateChanged?.Invoke(PlayModeStateChange.EnteredPlayMode);
    }

    /// <summary>The scene that was open before is open again.</summary>
    public static void ExitPlaymode()
    {
        if (!EngineState.IsPlaying) return;
        playModeStateChanged?.Invoke(PlayModeStateChange.ExitingPlayMode);
        PlaySession.End();
        if (s_OpenScene.Length > 0) SceneManagement.EditorSceneManager.OpenScene(s_OpenScene);
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
