using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor;

public sealed class GameObjectUtility
{
    public static void SetParentAndAlign(GameObject child, GameObject? parent)
    {
        if (!parent) return;
        child.transform.SetParent(parent!.transform, false);
        child.transform.SetLocalPositionAndRotation(Vector3.zero, Quaternion.identity);
        child.transform.localScale = Vector3.one;
        SetLayer(child, parent.layer);
    }

    static void SetLayer(GameObject target, int layer)
    {
        target.layer = layer;
        foreach (Transform child in target.transform) SetLayer(child.gameObject, layer);
    }

    public static void EnsureUniqueNameForSibling(GameObject self) =>
        self.name = UniqueName(self.name, Siblings(self));

    public static string GetUniqueNameForSibling(Transform? parent, string name) =>
        UniqueName(name, parent ? Names(parent!, null) : RootNames(null));

    static HashSet<string> Siblings(GameObject self) =>
        self.transform.parent ? Names(self.transform.parent, self) : RootNames(self);

    static HashSet<string> Names(Transform parent, GameObject? except)
    {
        var names = new HashSet<string>();
        foreach (Transform child in parent)
            if (child.gameObject != except) names.Add(child.name);
        return names;
    }

    static HashSet<string> RootNames(GameObject? except)
    {
        var names = new HashSet<string>();
        foreach (GameObject root in UnityEngine.SceneManagement.SceneManager.GetActiveScene().GetRootGameObjects())
            if (root != except) names.Add(root.name);
        return names;
    }

    static string UniqueName(string name, HashSet<string> taken)
    {
        string candidate = name;
        for (int i = 1; taken.Contains(candidate); i++) candidate = $"{name} ({i})";
        return candidate;
    }
}
