using System;
using UnityEngine;

namespace UnityEditor;

public static class ObjectFactory
{
    public static GameObject CreateGameObject(string name, params Type[] types)
    {
        var created = new GameObject(name, types);
        Undo.RegisterCreatedObjectUndo(created, "Create " + name);
        return created;
    }

    public static T AddComponent<T>(GameObject gameObject) where T : Component => Undo.AddComponent<T>(gameObject);
    public static Component AddComponent(GameObject gameObject, Type type) => Undo.AddComponent(gameObject, type);
    public static void PlaceGameObject(GameObject go, GameObject? parent = null) => GameObjectUtility.SetParentAndAlign(go, parent);
}
