using System;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Reads the project's assets through the importers; writing assets is not offered.</summary>
public sealed class AssetDatabase
{
    static IAssetDatabase Assets => EngineHooks.Assets ?? throw new InvalidOperationException("AssetDatabase: no project is open.");

    public static Object LoadMainAssetAtPath(string assetPath) => Assets.LoadMain(assetPath)!;
    public static Object LoadAssetAtPath(string assetPath, Type type) => Assets.Load(assetPath, type)!;
    public static T LoadAssetAtPath<T>(string assetPath) where T : Object => (T)Assets.Load(assetPath, typeof(T))!;
    public static Object[] LoadAllAssetsAtPath(string assetPath) => Assets.LoadAll(assetPath);
    public static string GUIDToAssetPath(string guid) => Assets.GuidToPath(guid);
    public static string AssetPathToGUID(string path) => Assets.PathToGuid(path);
    public static string GetAssetPath(Object assetObject) => assetObject && EngineHooks.Assets is { } assets ? assets.PathOf(assetObject) : "";
    public static bool Contains(Object obj) => GetAssetPath(obj).Length > 0;
    public static string[] FindAssets(string filter) => Assets.Find(filter, null);
    public static string[] FindAssets(string filter, string[] searchInFolders) => Assets.Find(filter, searchInFolders);
    public static void Refresh() { }
    public static void SaveAssets() { }
    public static void ImportAsset(string path) { }
}
