using System;
using System.Reflection;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>One property of a <see cref="SerializedObject"/>'s working copy.</summary>
public partial class SerializedProperty : IDisposable
{
    string m_Path;

    internal SerializedProperty(SerializedObject owner, string path)
    {
        serializedObject = owner;
        m_Path = path;
    }

    public SerializedObject serializedObject { get; }
    public string propertyPath => m_Path;
    public string name => m_Path.Length == 0 ? "Base" : PropertyPath.Split(m_Path)[^1];
    public int depth => m_Path.Length == 0 ? -1 : PropertyPath.Split(m_Path).Count - 1;
    public bool isExpanded { get; set; }
    public bool editable => true;
    public bool hasMultipleDifferentValues
    {
        get
        {
            foreach (SerializedObject other in serializedObject.Others())
                if (!SerializedEquality.Same(PropertyPath.Get(serializedObject, m_Path), PropertyPath.Get(other, m_Path))) return true;
            return false;
        }
    }

    public string tooltip => PropertyPath.FieldAt(serializedObject, m_Path)?.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
    public string type => ValueType.Name;
    public string displayName => ObjectNames.NicifyVariableName(name);

    Type ValueType => PropertyPath.TypeAt(serializedObject, m_Path) ?? throw new InvalidOperationException($"The property '{m_Path}' has disappeared.");

    internal static SerializedProperty? Find(SerializedObject owner, string path) =>
        path.Length > 0 && PropertyPath.TypeAt(owner, path) is not null ? new SerializedProperty(owner, path) : null;

    public SerializedProperty FindPropertyRelative(string relativePropertyPath) => Find(serializedObject, $"{m_Path}.{relativePropertyPath}")!;
    public SerializedProperty Copy() => new(serializedObject, m_Path) { isExpanded = isExpanded };
    public void Dispose() { }

    /// <summary>Walks the object's own fields that an inspector shows; enterChildren counts from the start only.</summary>
    public bool NextVisible(bool enterChildren)
    {
        FieldInfo[] fields = serializedObject.Fields;
        int index = m_Path.Length == 0 ? 0 : Array.FindIndex(fields, f => f.Name == PropertyPath.Split(m_Path)[0]) + 1;
        while (index < fields.Length && fields[index].IsDefined(typeof(HideInInspector))) index++;
        if (index >= fields.Length) return false;
        m_Path = fields[index].Name;
        return true;
    }

    public bool Next(bool enterChildren)
    {
        FieldInfo[] fields = serializedObject.Fields;
        int index = m_Path.Length == 0 ? 0 : Array.FindIndex(fields, f => f.Name == PropertyPath.Split(m_Path)[0]) + 1;
        if (index >= fields.Length) return false;
        m_Path = fields[index].Name;
        return true;
    }

    public void Reset() => m_Path = "";

    public SerializedPropertyType propertyType
    {
        get
        {
            Type t = ValueType;
            if (t.IsEnum) return SerializedPropertyType.Enum;
            if (typeof(Object).IsAssignableFrom(t)) return SerializedPropertyType.ObjectReference;
            if (t == typeof(bool)) return SerializedPropertyType.Boolean;
            if (t == typeof(float) || t == typeof(double)) return SerializedPropertyType.Float;
            if (t == typeof(string)) return SerializedPropertyType.String;
            if (t == typeof(char)) return SerializedPropertyType.Character;
            if (t.IsPrimitive) return SerializedPropertyType.Integer;
            return Enum.TryParse(t.Name, out SerializedPropertyType known) && SerializedFields.IsEngineValue(t) ? known : SerializedPropertyType.Generic;
        }
    }
}
