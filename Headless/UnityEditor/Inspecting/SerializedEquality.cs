using System;
using System.Collections;
using System.Reflection;
using Headless.Engine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Whether two serialised values are the same: objects by identity, lists by item, classes and structs by field.</summary>
static class SerializedEquality
{
    public static bool Same(object? a, object? b)
    {
        if (a is Object or null || b is Object or null) return Equals(a, b);
        if (a.GetType() != b.GetType()) return false;
        if (a is string or Enum || a.GetType().IsPrimitive || SerializedFields.IsEngineValue(a.GetType())) return a.Equals(b);
        if (a is IList first && b is IList second)
        {
            if (first.Count != second.Count) return false;
            for (int i = 0; i < first.Count; i++)
                if (!Same(first[i], second[i])) return false;
            return true;
        }
        foreach (FieldInfo field in SerializedFields.Of(a.GetType()))
            if (!Same(field.GetValue(a), field.GetValue(b))) return false;
        return true;
    }
}
