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

    public static Object InstantiatePrefab(Object assetComponentOrGameObject)
    {
        Object instance = Object.Instantiate(assetComponentOrGameObject);
        instance.name = assetComponentOrGameObject.name;
        return instance;
    }
}
