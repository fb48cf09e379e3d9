using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Import settings cannot be edited here: GetAtPath finds none.</summary>
public class AssetImporter : Object
{
    public string assetPath { get; internal set; } = "";
    public string userData { get; set; } = "";

    public static AssetImporter GetAtPath(string path) => null!;

    public void SaveAndReimport() { }
}
