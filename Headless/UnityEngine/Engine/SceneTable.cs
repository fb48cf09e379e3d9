using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Headless.Engine;

/// <summary>Loaded scenes, the active one, and the one that survives loading.</summary>
static class SceneTable
{
    static int s_NextHandle = -2;
    static SceneData? s_DontDestroyOnLoad;

    public static List<SceneData> Scenes { get; } = new();
    public static SceneData? Active { get; set; }

    /// <summary>Scenes that prefabs are edited in, and the like.</summary>
    public static List<SceneData> Previews { get; } = new();

    public static SceneData DontDestroyOnLoad
    {
        get
        {
            if (s_DontDestroyOnLoad is null)
            {
                s_DontDestroyOnLoad = new SceneData(s_NextHandle -= 2, "DontDestroyOnLoad", "DontDestroyOnLoad") { IsLoaded = true };
            }
            return s_DontDestroyOnLoad;
        }
    }

    public static SceneData Create(string name, string path, bool loaded)
    {
        var scene = new SceneData(s_NextHandle -= 2, name, path) { IsLoaded = loaded };
        Scenes.Add(scene);
        return scene;
    }

    public static SceneData CreatePreview(string name)
    {
        var scene = new SceneData(s_NextHandle -= 2, name, "") { IsLoaded = true, IsPreview = true };
        Previews.Add(scene);
        return scene;
    }

    public static void ClosePreview(SceneData scene)
    {
        DestroyRoots(scene);
        Previews.Remove(scene);
        scene.IsLoaded = false;
    }

    /// <summary>Whether a component takes part in the loaded scenes.</summary>
    public static bool IsInWorld(Component component) => component.OwnerOrNull?.SceneData is { IsPreview: false };

    public static SceneData ActiveOrCreate() => Active ??= Create("", "", loaded: true);

    public static SceneData? Find(int handle) =>
        s_DontDestroyOnLoad?.Handle == handle ? s_DontDestroyOnLoad : Scenes.Find(s => s.Handle == handle) ?? Previews.Find(s => s.Handle == handle);

    public static SceneData Require(Scene scene) => Find(scene.handle) ?? throw new ArgumentException("The scene is invalid.");

    public static void Move(GameObject root, SceneData scene)
    {
        if (ReferenceEquals(root.SceneData, scene)) return;
        root.SceneData?.RemoveRoot(root);
        Assign(root, scene);
        scene.AddRoot(root);
    }

    public static void Assign(GameObject gameObject, SceneData? scene)
    {
        gameObject.SceneData = scene;
        foreach (Transform child in gameObject.TransformCore.ChildList) Assign(child.OwnerOrNull!, scene);
    }

    public static void Unload(SceneData scene)
    {
        DestroyRoots(scene);
        Scenes.Remove(scene);
        scene.IsLoaded = false;
        if (ReferenceEquals(Active, scene)) Active = Scenes.Count > 0 ? Scenes[0] : null;
        SceneManager.SendUnloaded(scene.Scene);
    }

    public static void DestroyAll()
    {
        foreach (SceneData scene in Scenes.ToArray()) DestroyRoots(scene);
        foreach (SceneData scene in Previews.ToArray()) ClosePreview(scene);
        if (s_DontDestroyOnLoad is not null) DestroyRoots(s_DontDestroyOnLoad);
        Clear();
    }

    static void DestroyRoots(SceneData scene)
    {
        foreach (GameObject root in scene.Roots.ToArray())
            if (root.IsAlive) root.Deactivate();
        foreach (GameObject root in scene.Roots.ToArray())
            if (root.IsAlive) Destruction.Now(root);
    }

    public static void Clear()
    {
        Scenes.Clear();
        Active = null;
        s_DontDestroyOnLoad = null;
        SceneLoading.Clear();
    }
}
