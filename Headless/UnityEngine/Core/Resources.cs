using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public sealed class Resources
{
    public static Object[] FindObjectsOfTypeAll(Type type)
    {
        var found = new List<Object>();
        foreach (Object candidate in ObjectRegistry.Snapshot())
            if (type.IsInstanceOfType(candidate)) found.Add(candidate);
        return found.ToArray();
    }

    public static T[] FindObjectsOfTypeAll<T>() where T : Object
    {
        var found = new List<T>();
        foreach (Object candidate in ObjectRegistry.Snapshot())
            if (candidate is T match) found.Add(match);
        return found.ToArray();
    }

    public static Object Load(string path) => Load(path, typeof(Object));
    public static T Load<T>(string path) where T : Object => (T)Load(path, typeof(T));
    public static Object Load(string path, Type systemTypeInstance) => EngineHooks.LoadResource?.Invoke(path, systemTypeInstance)!;
    public static Object[] LoadAll(string path) => LoadAll(path, typeof(Object));

    public static Object[] LoadAll(string path, Type systemTypeInstance) =>
        EngineHooks.LoadAllResources?.Invoke(path, systemTypeInstance) ?? Array.Empty<Object>();

    public static T[] LoadAll<T>(string path) where T : Object => Array.ConvertAll(LoadAll(path, typeof(T)), o => (T)o);

    public static Object GetBuiltinResource(Type type, string path)
    {
        Object? found = EngineHooks.BuiltinResource?.Invoke(type, path);
        if (found is null) Debug.LogError($"The resource {path} could not be loaded from the resource file!");
        return found!;
    }

    public static T GetBuiltinResource<T>(string path) where T : Object => (T)GetBuiltinResource(typeof(T), path);

    public static Object InstanceIDToObject(int instanceID) => ObjectRegistry.Find(instanceID)!;
    public static bool InstanceIDIsValid(int instanceId) => ObjectRegistry.Find(instanceId) is not null;

    public static void UnloadAsset(Object assetToUnload)
    {
        if (assetToUnload is GameObject or Component)
            Debug.LogError("UnloadAsset may only be used on individual assets and can not be used on GameObject's / Components / AssetBundles or GameManagers");
    }

    /// <summary>Done at once: memory here is freed by the runtime or by Destroy.</summary>
    public static AsyncOperation UnloadUnusedAssets() => AsyncOperation.Completed();
}
