using Headless.Engine;
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

    public static bool MarkSceneDirty(Scene scene) => scene.IsValid();
}
