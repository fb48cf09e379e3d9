using System;
using Headless.Engine;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement;

public sealed class EditorSceneManager : SceneManager
{
    public static Scene OpenScene(string scenePath) => OpenScene(scenePath, OpenSceneMode.Single);

    public static Scene OpenScene(string scenePath, OpenSceneMode mode)
    {
        SceneLoading.Load(scenePath, mode == OpenSceneMode.Single ? LoadSceneMode.Single : LoadSceneMode.Additive, null);
        return GetSceneByPath(scenePath);
    }

    public static Scene NewScene(NewSceneSetup setup) => NewScene(setup, NewSceneMode.Single);

    public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode)
    {
        if (mode == NewSceneMode.Single)
            foreach (SceneData other in SceneTable.Scenes.ToArray()) SceneTable.Unload(other);
        SceneData scene = SceneTable.Create("", "", loaded: true);
        if (mode == NewSceneMode.Single)
        {
            SceneTable.Active = scene;
            RenderSettings.Reset();
            RenderSettings.skybox = Resources.GetBuiltinResource<Material>("Default-Skybox.mat");
        }
        if (setup == NewSceneSetup.DefaultGameObjects) AddDefaultObjects();
        return scene.Scene;
    }

    // Without an Audio Listener, which has no stand-in.
    static void AddDefaultObjects()
    {
        var camera = new GameObject("Main Camera", typeof(Camera)) { tag = "MainCamera" };
        camera.transform.position = new Vector3(0f, 1f, -10f);
        var sun = new GameObject("Directional Light", typeof(Light));
        sun.transform.SetPositionAndRotation(new Vector3(0f, 3f, 0f), Quaternion.Euler(50f, -30f, 0f));
        var light = sun.GetComponent<Light>();
        light.type = LightType.Directional;
        light.color = new Color(1f, 0.95686275f, 0.8392157f);
        light.shadows = LightShadows.Soft;
    }

    public static bool SaveScene(Scene scene) => SaveScene(scene, scene.path, false);

    public static bool SaveScene(Scene scene, string dstScenePath) => SaveScene(scene, dstScenePath, false);

    /// <summary>Writes the scene below the project folder. Components that cannot be written are an error here, where Unity writes all.</summary>
    public static bool SaveScene(Scene scene, string dstScenePath, bool saveAsCopy)
    {
        if (string.IsNullOrEmpty(dstScenePath)) throw new ArgumentException("A scene that is not a file needs a path to be saved at.", nameof(dstScenePath));
        SceneData data = SceneTable.Require(scene);
        (string path, string name) = (data.Path, data.Name);
        bool saved = EngineHooks.SaveScene?.Invoke(data, dstScenePath) ?? false;
        if (saveAsCopy) (data.Path, data.Name) = (path, name);
        return saved;
    }

    /// <summary>A scene apart: FindObjectsByType, the scene manager, cameras and the default physics do not know it.</summary>
    public static Scene NewPreviewScene() => SceneTable.CreatePreview("").Scene;

    public static bool ClosePreviewScene(Scene scene)
    {
        if (!IsPreviewScene(scene)) return false;
        SceneTable.ClosePreview(SceneTable.Require(scene));
        return true;
    }

    public static bool IsPreviewScene(Scene scene) => SceneTable.Find(scene.handle) is { IsPreview: true };

    public static bool IsPreviewSceneObject(UnityEngine.Object obj) =>
        (obj as GameObject ?? (obj as Component)?.gameObject) is { } placed && IsPreviewScene(placed.scene);

    public static bool MarkSceneDirty(Scene scene) => scene.IsValid();
}
