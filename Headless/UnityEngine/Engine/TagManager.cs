using System;
using System.Collections.Generic;

namespace Headless.Engine;

/// <summary>Layer and tag names; the importer fills the project's own from ProjectSettings/TagManager.asset.</summary>
static class TagManager
{
    static readonly string[] s_Layers = CreateLayers();
    static readonly HashSet<string> s_Tags = new(StringComparer.Ordinal)
    {
        "Untagged", "Respawn", "Finish", "EditorOnly", "MainCamera", "Player", "GameController",
    };

    public static string LayerName(int layer) => (uint)layer < 32u ? s_Layers[layer] : "";

    public static int LayerIndex(string name) => string.IsNullOrEmpty(name) ? -1 : Array.IndexOf(s_Layers, name);

    public static void SetLayer(int layer, string name) => s_Layers[layer] = name ?? "";

    public static bool IsTag(string tag) => s_Tags.Contains(tag);

    public static void AddTag(string tag) => s_Tags.Add(tag);

    static string[] CreateLayers()
    {
        var layers = new string[32];
        Array.Fill(layers, "");
        layers[0] = "Default";
        layers[1] = "TransparentFX";
        layers[2] = "Ignore Raycast";
        layers[4] = "Water";
        layers[5] = "UI";
        return layers;
    }
}
