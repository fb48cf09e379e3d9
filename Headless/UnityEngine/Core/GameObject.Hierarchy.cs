using System;
using System.Collections.Generic;

namespace UnityEngine;

public sealed partial class GameObject
{
    public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

    public T GetComponentInChildren<T>(bool includeInactive)
    {
        foreach (GameObject item in SelfAndChildren(includeInactive))
            foreach (Component component in item.m_Components)
                if (component is T match) return match;
        return default!;
    }

    public Component GetComponentInChildren(Type type) => GetComponentInChildren(type, false);

    public Component GetComponentInChildren(Type type, bool includeInactive)
    {
        foreach (GameObject item in SelfAndChildren(includeInactive))
            if (item.GetComponent(type) is { } match) return match;
        return null!;
    }

    public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

    public T[] GetComponentsInChildren<T>(bool includeInactive)
    {
        var list = new List<T>();
        GetComponentsInChildren(includeInactive, list);
        return list.ToArray();
    }

    public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
    {
        results.Clear();
        foreach (GameObject item in SelfAndChildren(includeInactive)) item.Collect(results);
    }

    public Component[] GetComponentsInChildren(Type type) => GetComponentsInChildren(type, false);

    public Component[] GetComponentsInChildren(Type type, bool includeInactive)
    {
        var list = new List<Component>();
        foreach (GameObject item in SelfAndChildren(includeInactive)) list.AddRange(item.GetComponents(type));
        return list.ToArray();
    }

    public T GetComponentInParent<T>() => GetComponentInParent<T>(false);

    public T GetComponentInParent<T>(bool includeInactive)
    {
        foreach (GameObject item in SelfAndParents(includeInactive))
            foreach (Component component in item.m_Components)
                if (component is T match) return match;
        return default!;
    }

    public Component GetComponentInParent(Type type) => GetComponentInParent(type, false);

    public Component GetComponentInParent(Type type, bool includeInactive)
    {
        foreach (GameObject item in SelfAndParents(includeInactive))
            if (item.GetComponent(type) is { } match) return match;
        return null!;
    }

    public T[] GetComponentsInParent<T>() => GetComponentsInParent<T>(false);

    public T[] GetComponentsInParent<T>(bool includeInactive)
    {
        var list = new List<T>();
        GetComponentsInParent(includeInactive, list);
        return list.ToArray();
    }

    public void GetComponentsInParent<T>(bool includeInactive, List<T> results)
    {
        results.Clear();
        foreach (GameObject item in SelfAndParents(includeInactive)) item.Collect(results);
    }

    public Component[] GetComponentsInParent(Type type) => GetComponentsInParent(type, false);

    public Component[] GetComponentsInParent(Type type, bool includeInactive)
    {
        var list = new List<Component>();
        foreach (GameObject item in SelfAndParents(includeInactive)) list.AddRange(item.GetComponents(type));
        return list.ToArray();
    }

    // Depth first, as documented. Prefab assets count as active when their own flags are set.
    IEnumerable<GameObject> SelfAndChildren(bool includeInactive)
    {
        CheckAlive();
        if (!includeInactive && !CountsAsActive) yield break;
        yield return this;
        foreach (Transform child in m_Transform.ChildrenSnapshot())
            foreach (GameObject item in child.OwnerOrNull!.SelfAndChildren(includeInactive))
                yield return item;
    }

    IEnumerable<GameObject> SelfAndParents(bool includeInactive)
    {
        CheckAlive();
        for (Transform? t = m_Transform; t is not null; t = t.ParentCore)
            if (includeInactive || t.OwnerOrNull!.CountsAsActive) yield return t.OwnerOrNull!;
    }

    bool CountsAsActive => SceneData is null ? m_ActiveSelf : IsActiveCached;
}
