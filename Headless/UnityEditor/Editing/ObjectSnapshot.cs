using System;
using System.Collections.Generic;
using System.Reflection;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The serialised state of one object, for undo and copying.</summary>
sealed class ObjectSnapshot
{
    readonly Object m_Target;
    readonly List<(FieldInfo Field, object? Value)> m_Fields = new();
    readonly string m_Name;
    readonly (bool Active, int Layer, string Tag)? m_Header;

    ObjectSnapshot(Object target)
    {
        m_Target = target;
        m_Name = target.name;
        if (target is GameObject gameObject)
        {
            m_Header = (gameObject.activeSelf, gameObject.layer, gameObject.tag);
            return;
        }
        var cloner = new Cloner();
        foreach (FieldInfo field in FieldsOf(target)) m_Fields.Add((field, cloner.CopyValue(field.GetValue(target), field.FieldType)));
    }

    public static ObjectSnapshot Take(Object target) => new(target);

    public void Restore() => ApplyTo(m_Target);

    public void ApplyTo(Object target)
    {
        if (!target) return;
        if (ReferenceEquals(target, m_Target)) target.name = m_Name;
        if (m_Header is { } header && target is GameObject gameObject)
        {
            gameObject.layer = header.Layer;
            gameObject.tag = header.Tag;
            gameObject.SetActive(header.Active);
            return;
        }
        var cloner = new Cloner();
        foreach (var (field, value) in m_Fields) field.SetValue(target, cloner.CopyValue(value, field.FieldType));
        if (target is Transform transform) transform.Invalidate();
        if (target is Behaviour behaviour) behaviour.RefreshActivation();
        if (target is MonoBehaviour or ScriptableObject) ScriptType.Of(target.GetType()).Invoke(target, "OnValidate");
    }

    static IEnumerable<FieldInfo> FieldsOf(Object target)
    {
        if (target is MonoBehaviour or ScriptableObject)
        {
            foreach (FieldInfo field in SerializedFields.Of(target.GetType())) yield return field;
            yield break;
        }
        const BindingFlags flags = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        for (Type? t = target.GetType(); t is not null && t != typeof(Component) && t != typeof(Object); t = t.BaseType)
            foreach (FieldInfo field in t.GetFields(flags))
                if (!field.IsInitOnly && SerializedFields.IsSerializable(field.FieldType, true) && !typeof(Transform).IsAssignableFrom(field.FieldType)) yield return field;
    }
}
