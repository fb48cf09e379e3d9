using System.Collections.Generic;
using System.Globalization;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public class EditorUtility
{
    static readonly HashSet<int> s_Dirty = new();

    public static void SetDirty(Object target) => s_Dirty.Add(target.GetInstanceID());
    public static void ClearDirty(Object target) => s_Dirty.Remove(target.GetInstanceID());
    public static bool IsDirty(Object target) => s_Dirty.Contains(target.GetInstanceID());
    public static bool IsPersistent(Object target) => target && target.IsPersistent;
    public static Object InstanceIDToObject(int instanceID) => Resources.InstanceIDToObject(instanceID);

    public static void CopySerialized(Object source, Object dest)
    {
        if (source.GetType() != dest.GetType()) throw new System.ArgumentException($"CopySerialized: '{dest.name}' is a {dest.GetType().Name}, not a {source.GetType().Name}.");
        ObjectSnapshot.Take(source).ApplyTo(dest);
        dest.name = source.name;
    }

    public static void CopySerializedIfDifferent(Object source, Object dest) => CopySerialized(source, dest);

    /// <summary>No one is there to choose.</summary>
    public static string OpenFolderPanel(string title, string folder, string defaultName) => "";

    /// <summary>No one is there to answer: the question and its cancel branch.</summary>
    public static bool DisplayDialog(string title, string message, string ok, string cancel)
    {
        Debug.Log($"{title}: {message} [{cancel}]");
        return false;
    }

    public static bool DisplayDialog(string title, string message, string ok)
    {
        Debug.Log($"{title}: {message}");
        return true;
    }

    public static void DisplayProgressBar(string title, string info, float progress) { }
    public static bool DisplayCancelableProgressBar(string title, string info, float progress) => false;
    public static void ClearProgressBar() { }
    public static string FormatBytes(int bytes) => FormatBytes((long)bytes);

    public static string FormatBytes(long bytes)
    {
        if (bytes < 1024) return bytes.ToString(CultureInfo.InvariantCulture) + " B";
        string[] units = { "KB", "MB", "GB", "TB" };
        double value = bytes / 1024.0;
        int unit = 0;
        for (; value >= 1024.0 && unit < units.Length - 1; unit++) value /= 1024.0;
        return value.ToString("0.0", CultureInfo.InvariantCulture) + " " + units[unit];
    }
}
