using System;
using System.Reflection;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Enters and leaves play mode around a scene. Scripts are never loaded anew: their statics outlive a play.</summary>
static class PlaySession
{
    /// <summary>Play mode with the given scene (name or path), or with an empty one.</summary>
    public static void Begin(string? scene, params Assembly[] scriptAssemblies)
    {
        EngineState.IsPlaying = true;
        EngineState.QuitRequested = false;
        EngineState.ScriptAssemblies = scriptAssemblies;
        FrameClock.Restart();
        RuntimeInitialize.Run(RuntimeInitializeLoadType.SubsystemRegistration);
        RuntimeInitialize.Run(RuntimeInitializeLoadType.AfterAssembliesLoaded);
        RuntimeInitialize.Run(RuntimeInitializeLoadType.BeforeSplashScreen);
        if (scene is not null) SceneLoading.Begin(scene, () => RuntimeInitialize.Run(RuntimeInitializeLoadType.BeforeSceneLoad));
        else
        {
            RuntimeInitialize.Run(RuntimeInitializeLoadType.BeforeSceneLoad);
            SceneTable.ActiveOrCreate();
        }
        RuntimeInitialize.Run(RuntimeInitializeLoadType.AfterSceneLoad);
    }

    /// <summary>OnApplicationQuit and Application.quitting, then OnDisable and OnDestroy for everything; the render pipeline is the last to go.</summary>
    public static void End()
    {
        if (!EngineState.IsPlaying) return;
        foreach (UnityEngine.Object instance in ObjectRegistry.Snapshot())
            if (instance is MonoBehaviour { IsAlive: true, isActiveAndEnabled: true } script) script.ScriptType.Invoke(script, "OnApplicationQuit");
        Application.SendQuitting();
        SceneTable.DestroyAll();
        Destruction.Clear();
        PlayableGraphs.Clear();
        UnityEngine.Rendering.RenderPipelineManager.Reset();
        EngineState.IsPlaying = false;
    }
}
