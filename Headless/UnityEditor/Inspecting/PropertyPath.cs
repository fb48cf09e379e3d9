using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;
using Headless.Engine;

namespace UnityEditor;

/// <summary>Reads and writes along a path such as "phases.Array.data[2].mass" in a SerializedObject's working copy.</summary>
static class PropertyPath
{
    const string ElementPrefix = "data[";

    /// <summary>The steps of a path: field names, "[i]" for elements, "size" for Array.size.</summary>
    public static List<string> Split(string path)
    {
        var steps = new List<string>();
        foreach (string part in path.Split('.'))
        {
            if (part == "Array" && steps.Count > 0) continue;
            steps.Add(part.StartsWith(ElementPrefix, StringComparison.Ordinal) ? part[4..] : part);
        }
        return steps;
    }

    public static Type? TypeAt(SerializedObject root, string path)
    {
        Type? type = null;
        foreach (string step in Split(path))
        {
            if (type is null) type = FieldOf(root.targetObject.GetType(), step)?.FieldType;
            else if (step[0] == '[') type = SerializedFields.ElementType(type);
            else if (step == "size" && SerializedFields.ElementType(type) is not null) type = typeof(int);
            else type = FieldOf(type, step)?.FieldType;
            if (type is null) return null;
        }
        return type;
    }

    public static FieldInfo? FieldAt(SerializedObject root, string path)
    {
        int dot = path.LastIndexOf('.');
        Type? owner = dot < 0 ? root.targetObject.GetType() : TypeAt(root, path[..dot]);
        return owner is null ? null : FieldOf(owner, path[(dot + 1)..]);
    }

    public static FieldInfo? FieldOf(Type type, string name) => Array.Find(SerializedFields.Of(type), f => f.Name == name);

    public static object? Get(SerializedObject root, string path)
    {
        List<string> steps = Split(path);
        root.TryGetRoot(steps[0], out object? value);
        for (int i = 1; i < steps.Count; i++) value = Child(value, steps[i]);
        return value;
    }

    public static void Set(SerializedObject root, string path, object? value)
    {
        List<string> steps = Split(path);
        var chain = new object?[steps.Count];
        root.TryGetRoot(steps[0], out chain[0]);
        for (int i = 1; i < steps.Count; i++) chain[i] = Child(chain[i - 1], steps[i]);
        chain[^1] = value;
        for (int i = steps.Count - 1; i > 0; i--) SetChild(chain[i - 1]!, steps[i], chain[i]);
        root.SetRoot(steps[0], chain[0]);
    }

    static object? Child(object? owner, string step)
    {
        if (owner is null) return null;
        if (step[0] == '[') return ((IList)owner)[Index(step)];
        if (step == "size" && owner is IList list) return list.Count;
        return FieldOf(owner.GetType(), step)?.GetValue(owner);
    }

    static void SetChild(object owner, string step, object? value)
    {
        if (step[0] == '[') ((IList)owner)[Index(step)] = value;
        else FieldOf(owner.GetType(), step)!.SetValue(owner, value);
    }

    static int Index(string step) => int.Parse(step.AsSpan(1, step.Length - 2), CultureInfo.InvariantCulture);
}
