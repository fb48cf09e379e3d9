using System;
using Headless.Engine;
using UnityEngine.Events;

namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static event UnityAction<Scene, LoadSceneMode>? sceneLoaded;
    public static event UnityAction<Scene>? sceneUnloaded;
    public static event UnityAction<Scene, Scene>? activeSceneChanged;

    public static int sceneCount => SceneTable.Scenes.Count;
    public static int loadedSceneCount => SceneTable.Scenes.FindAll(s => s.IsLoaded).Count;
    public static int sceneCountInBuildSettings => SceneLoading.ScenesInBuild.Count;

    public static Scene GetActiveScene() => SceneTable.Active?.Scene ?? default;
    public static Scene GetSceneAt(int index) => SceneTable.Scenes[index].Scene;
    public static Scene GetSceneByPath(string scenePath) => SceneTable.Scenes.Find(s => s.Path == scenePath)?.Scene ?? default;
    public static Scene GetSceneByName(string name) => SceneTable.Scenes.Find(s => s.Name == name)?.Scene ?? default;
    public static Scene GetSceneByBuildIndex(int buildIndex) => SceneTable.Scenes.Find(s => s.BuildIndex == buildIndex)?.Scene ?? default;

    public static bool SetActiveScene(Scene scene)
    {
        SceneData data = SceneTable.Require(scene);
        if (!data.IsLoaded) return false;
        SceneData? previous = SceneTable.Active;
        if (ReferenceEquals(previous, data)) return true;
        SceneTable.Active = data;
        activeSceneChanged?.Invoke(previous?.Scene ?? default, scene);
        return true;
    }

    public static Scene CreateScene(string sceneName)
    {
        if (string.IsNullOrEmpty(sceneName)) throw new ArgumentException("SceneManager.CreateScene: the scene needs a name.", nameof(sceneName));
        if (GetSceneByName(sceneName).IsValid()) throw new ArgumentException($"Scene with name \"{sceneName}\" already exists.", nameof(sceneName));
        return SceneTable.Create(sceneName, "", loaded: true).Scene;
    }

    public static void MoveGameObjectToScene(GameObject go, Scene scene)
    {
        if (go.transform.parent != null) throw new ArgumentException("Gameobject is not a root in a scene", nameof(go));
        SceneTable.Move(go, SceneTable.Require(scene));
    }

    public static void MergeScenes(Scene sourceScene, Scene destinationScene)
    {
        foreach (GameObject root in sourceScene.GetRootGameObjects()) MoveGameObjectToScene(root, destinationScene);
        SceneTable.Unload(SceneTable.Require(sourceScene));
    }

    public static void LoadScene(string sceneName) => LoadScene(sceneName, LoadSceneMode.Single);
    public static void LoadScene(string sceneName, LoadSceneMode mode) => SceneLoading.Request(sceneName, mode);
    public static void LoadScene(int sceneBuildIndex) => LoadScene(sceneBuildIndex, LoadSceneMode.Single);
    public static void LoadScene(int sceneBuildIndex, LoadSceneMode mode) => SceneLoading.Request(SceneLoading.PathOf(sceneBuildIndex), mode);
    public static AsyncOperation LoadSceneAsync(string sceneName) => LoadSceneAsync(sceneName, LoadSceneMode.Single);
    public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneMode mode) => SceneLoading.Request(sceneName, mode);
    public static AsyncOperation LoadSceneAsync(int sceneBuildIndex) => LoadSceneAsync(sceneBuildIndex, LoadSceneMode.Single);
    public static AsyncOperation LoadSceneAsync(int sceneBuildIndex, LoadSceneMode mode) => SceneLoading.Request(SceneLoading.PathOf(sceneBuildIndex), mode);
    public static AsyncOperation UnloadSceneAsync(Scene scene) => SceneLoading.RequestUnload(SceneTable.Require(scene));
    public static AsyncOperation UnloadSceneAsync(string sceneName) => UnloadSceneAsync(GetSceneByName(sceneName));

    internal static void SendLoaded(Scene scene, LoadSceneMode mode) => sceneLoaded?.Invoke(scene, mode);
    internal static void SendUnloaded(Scene scene) => sceneUnloaded?.Invoke(scene);
}
