using System.Collections.Concurrent;
using System.Reflection;
using UnityEngine;
using UnityEngine.Serialization;

namespace Headless.Importers.Serialization;

/// <summary>
/// Which fields Unity serialises (manual page "Script serialization"): public or [SerializeField], not static, const,
/// readonly or [NonSerialized], of a serialisable type; base class first, in declaration order.
/// </summary>
public static class SerializationRules
{
    private static readonly ConcurrentDictionary<Type, IReadOnlyList<SerializedField>> known = new();

    public static IReadOnlyList<SerializedField> FieldsOf(Type type) => known.GetOrAdd(type, Collect);

    public static bool IsSerializable(Type type) => ElementType(type) is { } element ? IsSingle(element) : IsSingle(type);

    /// <summary>Element type of T[] and List&lt;T&gt;; null for other types.</summary>
    public static Type? ElementType(Type type)
    {
        if (type.IsArray) return type.GetArrayRank() == 1 ? type.GetElementType() : null;
        return type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>) ? type.GetGenericArguments()[0] : null;
    }

    private static bool IsSingle(Type type)
    {
        if (type.IsPrimitive) return type != typeof(IntPtr) && type != typeof(UIntPtr);
        if (type == typeof(string) || type == typeof(PropertyName) || type.IsEnum || ValueReaders.Knows(type)) return true;
        if (typeof(UnityEngine.Object).IsAssignableFrom(type)) return true;
        if (type.IsAbstract || type.IsInterface || ElementType(type) is not null || type.IsArray) return false;
        return type.IsDefined(typeof(SerializableAttribute), false) && type.Namespace is not ("System" or "System.Collections.Generic");
    }

    private static IReadOnlyList<SerializedField> Collect(Type type)
    {
        var chain = new Stack<Type>();
        for (Type? t = type; t is not null && t != typeof(object) && !IsEngineBase(t); t = t.BaseType) chain.Push(t);
        var fields = new List<SerializedField>();
        foreach (Type t in chain)
            foreach (FieldInfo field in t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly).OrderBy(f => f.MetadataToken))
                if (Describe(field) is { } described) fields.Add(described);
        return fields;
    }

    private static bool IsEngineBase(Type t) => t == typeof(MonoBehaviour) || t == typeof(ScriptableObject) || t == typeof(UnityEngine.Object);

    private static SerializedField? Describe(FieldInfo field)
    {
        if (field.IsInitOnly || field.IsDefined(typeof(NonSerializedAttribute), false)) return null;
        bool byReference = field.IsDefined(typeof(SerializeReference), false);
        if (!field.IsPublic && !byReference && !field.IsDefined(typeof(SerializeField), false)) return null;
        if (!byReference && !IsSerializable(field.FieldType)) return null;
        List<string> names = [field.Name];
        names.AddRange(field.GetCustomAttributes<FormerlySerializedAsAttribute>(false).Select(a => a.oldName));
        return new SerializedField(field, names, byReference);
    }
}
