using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>GameObject.Find and search by tag: active objects only.</summary>
static class SceneSearch
{
    public static GameObject? ByPath(string name)
    {
        if (string.IsNullOrEmpty(name)) return null;
        bool fromRoot = name[0] == '/';
        string[] parts = name.Split('/', StringSplitOptions.RemoveEmptyEntries);
        foreach (GameObject candidate in Active())
        {
            if (parts.Length == 0 || candidate.NameCore != parts[0]) continue;
            if (fromRoot && candidate.TransformCore.ParentCore is not null) continue;
            if (parts.Length == 1) return candidate;
            Transform? below = candidate.TransformCore.Find(string.Join('/', parts, 1, parts.Length - 1));
            if (below is not null && below.OwnerOrNull!.IsActiveCached) return below.OwnerOrNull;
        }
        return null;
    }

    public static GameObject[] ActiveWithTag(string tag)
    {
        var found = new List<GameObject>();
        foreach (GameObject candidate in Active())
            if (candidate.tag == tag) found.Add(candidate);
        return found.ToArray();
    }

    static IEnumerable<GameObject> Active()
    {
        foreach (UnityEngine.Object instance in ObjectRegistry.Snapshot())
            if (instance is GameObject { IsActiveCached: true, SceneData: { IsPreview: false } } gameObject) yield return gameObject;
    }
}
