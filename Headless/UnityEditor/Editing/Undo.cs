using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Steps by group; PerformUndo takes back the last group.</summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    sealed record Step(int Group, string Name, Action Revert);

    static readonly List<Step> s_Steps = new();
    static int s_Group;
    static string s_GroupName = "";

    public static UndoRedoCallback? undoRedoPerformed;

    public static bool isProcessing { get; private set; }

    public static int GetCurrentGroup() => s_Group;
    public static string GetCurrentGroupName() => s_GroupName;
    public static void SetCurrentGroupName(string name) => s_GroupName = name;
    public static void IncrementCurrentGroup() => s_Group++;
    public static void FlushUndoRecordObjects() { }
    public static void ClearAll() => s_Steps.Clear();

    public static void CollapseUndoOperations(int groupIndex)
    {
        for (int i = 0; i < s_Steps.Count; i++)
            if (s_Steps[i].Group > groupIndex) s_Steps[i] = s_Steps[i] with { Group = groupIndex };
    }

    public static void RecordObject(Object objectToUndo, string name)
    {
        if (!objectToUndo) return;
        Add(name, ObjectSnapshot.Take(objectToUndo).Restore);
    }

    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        foreach (Object item in objectsToUndo) RecordObject(item, name);
    }

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => RecordObject(objectToUndo, name);
    public static void RegisterCompleteObjectUndo(Object[] objectsToUndo, string name) => RecordObjects(objectsToUndo, name);

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) => Add(name, () =>
    {
        if (objectToUndo) Object.DestroyImmediate(objectToUndo);
    });

    public static T AddComponent<T>(GameObject gameObject) where T : Component => (T)AddComponent(gameObject, typeof(T));

    public static Component AddComponent(GameObject gameObject, Type type)
    {
        Component component = gameObject.AddComponent(type);
        RegisterCreatedObjectUndo(component, "Add Component");
        return component;
    }

    public static void SetTransformParent(Transform transform, Transform newParent, string name)
    {
        Transform old = transform.parent;
        Add(name, () => transform.SetParent(old));
        transform.SetParent(newParent);
    }

    /// <summary>The object dies for good here: destruction is the one operation that is not taken back.</summary>
    public static void DestroyObjectImmediate(Object objectToUndo) => Object.DestroyImmediate(objectToUndo);

    public static void PerformUndo()
    {
        if (s_Steps.Count == 0) return;
        int group = s_Steps[^1].Group;
        isProcessing = true;
        while (s_Steps.Count > 0 && s_Steps[^1].Group == group)
        {
            Step step = s_Steps[^1];
            s_Steps.RemoveAt(s_Steps.Count - 1);
            step.Revert();
        }
        isProcessing = false;
        undoRedoPerformed?.Invoke();
    }

    static void Add(string name, Action revert)
    {
        s_GroupName = name;
        s_Steps.Add(new Step(s_Group, name, revert));
    }
}
