using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Instantiate: copies a hierarchy without running it, points references inside it at the copies, then wakes it.</summary>
sealed class Cloner
{
    readonly Dictionary<Object, Object> m_Copies = new(ReferenceEqualityComparer.Instance);

    public static Object Clone(Object original, Transform? parent, bool worldPositionStays, SceneData? scene) =>
        Clone(original, copy =>
        {
            if (parent && worldPositionStays) copy.TransformCore.SetParent(parent, true);
            else if (parent) copy.TransformCore.Relink(parent);
            else if (scene is not null) SceneTable.Move(copy, scene);
        });

    public static Object Clone(Object original, Transform? parent, Vector3 position, Quaternion rotation) =>
        Clone(original, copy =>
        {
            if (parent) copy.TransformCore.Relink(parent);
            copy.TransformCore.SetPositionAndRotation(position, rotation);
        });

    static Object Clone(Object original, Action<GameObject> place)
    {
        if (!original) throw new ArgumentException("The Object you want to instantiate is null.");
        if (original is not (GameObject or Component))
        {
            Object copy = original.CloneNative();
            copy.NameCore = original.NameCore + "(Clone)";
            return copy;
        }
        var cloner = new Cloner();
        GameObject source = original as GameObject ?? ((Component)original).gameObject;
        GameObject root = cloner.CopyHierarchy(source, null);
        root.NameCore = source.NameCore + "(Clone)";
        foreach (var (from, to) in cloner.m_Copies)
            if (from is Component component) ((Component)to).CopyNativeState(component, cloner);
        place(root);
        foreach (Object copy in cloner.m_Copies.Values)
            if (copy is ISerializationCallbackReceiver receiver) receiver.OnAfterDeserialize();
        if (root.SceneData is not null) ObjectFactory.Activate(new[] { root });
        return cloner.m_Copies[original];
    }

    GameObject CopyHierarchy(GameObject source, Transform? parent)
    {
        var copy = new GameObject(source.NameCore, SceneTable.ActiveOrCreate(), joinWorld: false);
        copy.SetActiveRaw(source.activeSelf);
        copy.layer = source.layer;
        copy.SetTagRaw(source.tag);
        copy.isStatic = source.isStatic;
        m_Copies.Add(source, copy);
        if (parent is not null) copy.TransformCore.Relink(parent);
        foreach (Component component in source.ComponentList)
        {
            if (component is ISerializationCallbackReceiver receiver) receiver.OnBeforeSerialize();
            m_Copies.Add(component, component is Transform ? copy.TransformCore : copy.AddComponentRaw(component.GetType()));
        }
        foreach (Transform child in source.TransformCore.ChildList) CopyHierarchy(child.OwnerOrNull!, copy.TransformCore);
        return copy;
    }

    /// <summary>Script state: serialised fields only, deeply copied.</summary>
    public void CopySerialized(object source, object target)
    {
        foreach (FieldInfo field in SerializedFields.Of(source.GetType()))
            field.SetValue(target, CopyValue(field.GetValue(source), field.FieldType));
    }

    /// <summary>State of an engine component: every instance field of its own classes below Component.</summary>
    public void CopyEngineFields(Component source, Component target)
    {
        for (Type? t = source.GetType(); t is not null && t != typeof(Behaviour) && t != typeof(Component); t = t.BaseType)
            foreach (FieldInfo field in t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
            {
                if (field.IsDefined(typeof(NonSerializedAttribute)) || (field.IsInitOnly && !field.FieldType.IsValueType)) continue;
                object? value = field.GetValue(source);
                field.SetValue(target, value switch
                {
                    Object reference => Remap(reference),
                    Array array => array.Clone(),
                    _ => value,
                });
            }
    }

    Object Remap(Object reference) => m_Copies.GetValueOrDefault(reference, reference);

    public object? CopyValue(object? value, Type type)
    {
        switch (value)
        {
            case null:
                return null;
            case Object reference:
                return Remap(reference);
            case string or Enum:
                return value;
            case Array array:
                var copy = (Array)array.Clone();
                Type element = type.IsArray ? type.GetElementType()! : array.GetType().GetElementType()!;
                if (!element.IsPrimitive)
                    for (int i = 0; i < copy.Length; i++) copy.SetValue(CopyValue(copy.GetValue(i), element), i);
                return copy;
            case IList list when SerializedFields.ElementType(value.GetType()) is { } item:
                var result = (IList)Activator.CreateInstance(value.GetType())!;
                foreach (object? entry in list) result.Add(CopyValue(entry, item));
                return result;
        }
        Type actual = value.GetType();
        if (actual.IsPrimitive || SerializedFields.IsEngineValue(actual)) return value;
        object instance = Activator.CreateInstance(actual, nonPublic: true)!;
        CopySerialized(value, instance);
        return instance;
    }
}
