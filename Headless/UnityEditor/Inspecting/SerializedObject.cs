using System;
using System.Collections.Generic;
using System.Reflection;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>A working copy of an object's serialised fields, written back by ApplyModifiedProperties. With several targets the first is shown, and what was changed is written to all.</summary>
public class SerializedObject : IDisposable
{
    readonly Object[] m_Targets;
    readonly Dictionary<string, object?> m_Values = new();
    readonly HashSet<string> m_Modified = new();

    public SerializedObject(Object obj) : this(new[] { obj }) { }

    public SerializedObject(Object[] objs)
    {
        if (objs is not { Length: > 0 } || !objs[0]) throw new ArgumentException("Object at index 0 is null");
        m_Targets = objs;
        Update();
    }

    public Object targetObject => m_Targets[0];
    public Object[] targetObjects => m_Targets;
    public bool isEditingMultipleObjects => m_Targets.Length > 1;
    public bool hasModifiedProperties => m_Modified.Count > 0;

    internal FieldInfo[] Fields => SerializedFields.Of(targetObject.GetType());

    public void Update()
    {
        var cloner = new Cloner();
        foreach (FieldInfo field in Fields) m_Values[field.Name] = cloner.CopyValue(field.GetValue(targetObject), field.FieldType);
        m_Modified.Clear();
    }

    public bool UpdateIfRequiredOrScript()
    {
        Update();
        return true;
    }

    public bool ApplyModifiedProperties()
    {
        if (!hasModifiedProperties) return false;
        Undo.RecordObjects(m_Targets, "Inspector");
        return ApplyModifiedPropertiesWithoutUndo();
    }

    public bool ApplyModifiedPropertiesWithoutUndo()
    {
        if (!hasModifiedProperties) return false;
        var cloner = new Cloner();
        foreach (Object target in m_Targets)
        {
            foreach (FieldInfo field in Fields)
                if (m_Modified.Contains(field.Name)) field.SetValue(target, cloner.CopyValue(m_Values[field.Name], field.FieldType));
            EditorUtility.SetDirty(target);
            ScriptType.Of(target.GetType()).Invoke(target, "OnValidate");
        }
        m_Modified.Clear();
        return true;
    }

    public SerializedProperty FindProperty(string propertyPath) => SerializedProperty.Find(this, propertyPath)!;
    public SerializedProperty GetIterator() => new(this, "");

    /// <summary>The working copies of the other targets, to compare with.</summary>
    internal IEnumerable<SerializedObject> Others()
    {
        for (int i = 1; i < m_Targets.Length; i++) yield return new SerializedObject(m_Targets[i]);
    }

    internal bool TryGetRoot(string name, out object? value) => m_Values.TryGetValue(name, out value);

    internal void SetRoot(string name, object? value)
    {
        m_Values[name] = value;
        m_Modified.Add(name);
    }

    public void Dispose() { }
}
