using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Headless.Engine;

/// <summary>Scene loads take effect at the start of the next frame, as SceneManager.LoadScene documents.</summary>
static class SceneLoading
{
    static readonly List<(string Name, LoadSceneMode Mode, AsyncOperation Operation)> s_Pending = new();
    static readonly List<(SceneData Scene, AsyncOperation Operation)> s_Unloads = new();

    public static IReadOnlyList<string> ScenesInBuild => EngineHooks.ScenesInBuild?.Invoke() ?? Array.Empty<string>();

    public static string PathOf(int buildIndex)
    {
        IReadOnlyList<string> scenes = ScenesInBuild;
        if ((uint)buildIndex >= (uint)scenes.Count)
            throw new ArgumentException($"Scene with build index: {buildIndex} couldn't be loaded because it has not been added to the build settings.");
        return scenes[buildIndex];
    }

    public static AsyncOperation Request(string name, LoadSceneMode mode)
    {
        var operation = new AsyncOperation();
        s_Pending.Add((name, mode, operation));
        return operation;
    }

    public static AsyncOperation RequestUnload(SceneData scene)
    {
        var operation = new AsyncOperation();
        s_Unloads.Add((scene, operation));
        return operation;
    }

    public static void RunPending()
    {
        foreach (var (scene, operation) in s_Unloads.ToArray())
        {
            SceneTable.Unload(scene);
            operation.Finish();
        }
        s_Unloads.Clear();
        var batch = s_Pending.ToArray();
        s_Pending.Clear();
        foreach (var (name, mode, operation) in batch)
        {
            Load(name, mode, null);
            operation.Finish();
        }
    }

    /// <summary>The first scene of a run; beforeAwake is called when its objects exist and none has woken.</summary>
    public static void Begin(string name, Action beforeAwake) => Load(name, LoadSceneMode.Single, beforeAwake);

    public static void Load(string name, LoadSceneMode mode, Action? beforeAwake)
    {
        var scene = SceneTable.Create(Path.GetFileNameWithoutExtension(name), name, loaded: false);
        if (EngineHooks.LoadScene is null || !EngineHooks.LoadScene(name, scene))
        {
            SceneTable.Scenes.Remove(scene);
            Debug.LogError($"Scene '{name}' couldn't be loaded because it has not been added to the build settings or the file does not exist.");
            return;
        }
        if (mode == LoadSceneMode.Single)
        {
            foreach (SceneData other in SceneTable.Scenes.ToArray())
                if (!ReferenceEquals(other, scene)) SceneTable.Unload(other);
            SceneTable.Active = scene;
        }
        FrameClock.MarkLevelLoad();
        beforeAwake?.Invoke();
        ObjectFactory.Activate(scene);
        SceneManager.SendLoaded(scene.Scene, mode);
    }

    public static void Clear()
    {
        s_Pending.Clear();
        s_Unloads.Clear();
    }
}
