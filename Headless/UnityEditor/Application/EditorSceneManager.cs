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
        if (mode == NewSceneMode.Single) SceneTable.Active = scene;
        return scene.Scene;
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
