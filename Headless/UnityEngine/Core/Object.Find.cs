using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public partial class Object
{
    public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode) where T : Object => Find<T>(typeof(T), false, sortMode);

    public static T[] FindObjectsByType<T>(FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode) where T : Object =>
        Find<T>(typeof(T), findObjectsInactive == FindObjectsInactive.Include, sortMode);

    public static Object[] FindObjectsByType(Type type, FindObjectsSortMode sortMode) => Find<Object>(type, false, sortMode);

    public static Object[] FindObjectsByType(Type type, FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode) =>
        Find<Object>(type, findObjectsInactive == FindObjectsInactive.Include, sortMode);

    public static T FindFirstObjectByType<T>() where T : Object => First<T>(typeof(T), false)!;
    public static T FindFirstObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object => First<T>(typeof(T), findObjectsInactive == FindObjectsInactive.Include)!;
    public static Object FindFirstObjectByType(Type type) => First<Object>(type, false)!;
    public static Object FindFirstObjectByType(Type type, FindObjectsInactive findObjectsInactive) => First<Object>(type, findObjectsInactive == FindObjectsInactive.Include)!;
    public static T FindAnyObjectByType<T>() where T : Object => First<T>(typeof(T), false)!;
    public static T FindAnyObjectByType<T>(FindObjectsInactive findObjectsInactive) where T : Object => First<T>(typeof(T), findObjectsInactive == FindObjectsInactive.Include)!;
    public static Object FindAnyObjectByType(Type type) => First<Object>(type, false)!;
    public static Object FindAnyObjectByType(Type type, FindObjectsInactive findObjectsInactive) => First<Object>(type, findObjectsInactive == FindObjectsInactive.Include)!;
    public static T FindObjectOfType<T>() where T : Object => First<T>(typeof(T), false)!;
    public static T FindObjectOfType<T>(bool includeInactive) where T : Object => First<T>(typeof(T), includeInactive)!;
    public static Object FindObjectOfType(Type type) => First<Object>(type, false)!;
    public static Object FindObjectOfType(Type type, bool includeInactive) => First<Object>(type, includeInactive)!;
    public static T[] FindObjectsOfType<T>() where T : Object => Find<T>(typeof(T), false, FindObjectsSortMode.InstanceID);
    public static T[] FindObjectsOfType<T>(bool includeInactive) where T : Object => Find<T>(typeof(T), includeInactive, FindObjectsSortMode.InstanceID);
    public static Object[] FindObjectsOfType(Type type) => Find<Object>(type, false, FindObjectsSortMode.InstanceID);
    public static Object[] FindObjectsOfType(Type type, bool includeInactive) => Find<Object>(type, includeInactive, FindObjectsSortMode.InstanceID);

    static T? First<T>(Type type, bool includeInactive) where T : Object
    {
        T[] all = Find<T>(type, includeInactive, FindObjectsSortMode.InstanceID);
        return all.Length > 0 ? all[0] : null;
    }

    // Assets, objects hidden by HideFlags.DontSave and objects outside the loaded scenes are not found, as documented.
    static T[] Find<T>(Type type, bool includeInactive, FindObjectsSortMode sortMode) where T : Object
    {
        ArgumentNullException.ThrowIfNull(type);
        var found = new List<T>();
        foreach (Object candidate in ObjectRegistry.Snapshot())
        {
            if (!type.IsInstanceOfType(candidate) || candidate is not T match) continue;
            if ((candidate.m_HideFlags & HideFlags.DontSave) == HideFlags.DontSave) continue;
            GameObject? owner = candidate as GameObject ?? (candidate as Component)?.OwnerOrNull;
            if (owner is not null)
            {
                if (owner.SceneData is null or { IsPreview: true } || (owner.m_HideFlags & HideFlags.DontSave) == HideFlags.DontSave) continue;
                if (!includeInactive && !owner.activeInHierarchy) continue;
            }
            else if (candidate.IsPersistent)
            {
                continue;
            }
            found.Add(match);
        }
        if (sortMode == FindObjectsSortMode.InstanceID) found.Sort((a, b) => a.m_InstanceID.CompareTo(b.m_InstanceID));
        return found.ToArray();
    }
}
