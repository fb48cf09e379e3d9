using System;
using System.Collections;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>The fields Unity serialises: public or [SerializeField], not static, readonly or [NonSerialized], of a serialisable type.</summary>
static class SerializedFields
{
    static readonly ConcurrentDictionary<Type, FieldInfo[]> s_Fields = new();

    /// <summary>Base class first, in order of declaration.</summary>
    public static FieldInfo[] Of(Type type) => s_Fields.GetOrAdd(type, Collect);

    static FieldInfo[] Collect(Type type)
    {
        var chain = new Stack<Type>();
        for (Type? t = type; t is not null && !IsRoot(t); t = t.BaseType) chain.Push(t);
        var fields = new List<FieldInfo>();
        foreach (Type t in chain)
            foreach (FieldInfo field in t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
                if (IsSerialized(field)) fields.Add(field);
        return fields.ToArray();
    }

    static bool IsRoot(Type t) => t == typeof(object) || t == typeof(ValueType) || t == typeof(MonoBehaviour) || t == typeof(ScriptableObject) || t == typeof(Object);

    static bool IsSerialized(FieldInfo field)
    {
        if (field.IsStatic || field.IsInitOnly || field.IsLiteral || field.IsDefined(typeof(NonSerializedAttribute))) return false;
        if (field.IsDefined(typeof(SerializeReference))) return true;
        return (field.IsPublic || field.IsDefined(typeof(SerializeField))) && IsSerializable(field.FieldType, true);
    }

    public static bool IsSerializable(Type type, bool allowCollection)
    {
        if (type.IsPrimitive || type.IsEnum || type == typeof(string)) return type != typeof(IntPtr) && type != typeof(UIntPtr);
        if (typeof(Object).IsAssignableFrom(type)) return true;
        if (allowCollection && ElementType(type) is { } element) return IsSerializable(element, false);
        if (type.IsArray || type.IsAbstract || type.IsInterface || typeof(Delegate).IsAssignableFrom(type)) return false;
        if (type.Namespace is { } ns && (ns == "System" || ns.StartsWith("System.", StringComparison.Ordinal))) return false;
        return IsEngineValue(type) || type.IsDefined(typeof(SerializableAttribute), false);
    }

    /// <summary>The element type of T[] or List&lt;T&gt;; null for anything else.</summary>
    public static Type? ElementType(Type type)
    {
        if (type.IsArray && type.GetArrayRank() == 1) return type.GetElementType();
        return type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>) ? type.GetGenericArguments()[0] : null;
    }

    /// <summary>Vector3, Color and the like: copied whole.</summary>
    public static bool IsEngineValue(Type type) => type.IsValueType && type.Assembly == typeof(Vector3).Assembly;
}
