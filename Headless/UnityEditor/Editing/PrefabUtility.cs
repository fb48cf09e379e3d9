using System;
using Headless.Engine;
using UnityEditor.SceneManagement;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Scenes here hold expanded objects: instances have no link back to their prefab.</summary>
public sealed class PrefabUtility
{
    public static void RecordPrefabInstancePropertyModifications(Object targetObject) { }
    public static bool IsPartOfAnyPrefab(Object componentOrGameObject) => IsPartOfPrefabAsset(componentOrGameObject);
    public static bool IsPartOfPrefabInstance(Object componentOrGameObject) => false;

    public static bool IsPartOfPrefabAsset(Object componentOrGameObject) =>
        componentOrGameObject && componentOrGameObject.IsPersistent && componentOrGameObject is GameObject or Component;

    /// <summary>A prefab in a preview scene of its own, as it is edited by itself. No script runs.</summary>
    public static GameObject LoadPrefabContents(string assetPath)
    {
        var asset = AssetDatabase.LoadAssetAtPath<GameObject>(assetPath);
        if (!asset) throw new ArgumentException($"Could not load Prefab contents at path {assetPath}.");
        SceneData scene = SceneTable.CreatePreview(asset.name);
        var contents = (GameObject)Object.Instantiate(asset, scene.Scene);
        contents.name = asset.name;
        return contents;
    }

    public static void UnloadPrefabContents(GameObject contentsRoot)
    {
        if (!contentsRoot) throw new ArgumentNullException(nameof(contentsRoot));
        if (!EditorSceneManager.ClosePreviewScene(contentsRoot.scene))
            throw new ArgumentException("Specified object is not part of Prefab contents.");
    }

    public static Object InstantiatePrefab(Object assetComponentOrGameObject)
    {
        Object instance = Object.Instantiate(assetComponentOrGameObject);
        instance.name = assetComponentOrGameObject.name;
        return instance;
    }
}
