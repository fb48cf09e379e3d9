using System;
using System.Collections;
using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public partial class SerializedProperty
{
    public object boxedValue { get => Value!; set => Value = value; }

    object? Value
    {
        get => PropertyPath.Get(serializedObject, m_Path);
        set => PropertyPath.Set(serializedObject, m_Path, value);
    }

    public bool boolValue { get => (bool)Value!; set => Value = value; }
    public int intValue { get => (int)longValue; set => longValue = value; }
    public uint uintValue { get => (uint)longValue; set => longValue = value; }
    public float floatValue { get => (float)doubleValue; set => doubleValue = value; }
    public string stringValue { get => (string?)Value ?? ""; set => Value = value; }
    public Object objectReferenceValue { get => (Object)Value!; set => Value = value; }
    public Vector2 vector2Value { get => (Vector2)Value!; set => Value = value; }
    public Vector3 vector3Value { get => (Vector3)Value!; set => Value = value; }
    public Vector4 vector4Value { get => (Vector4)Value!; set => Value = value; }
    public Vector2Int vector2IntValue { get => (Vector2Int)Value!; set => Value = value; }
    public Vector3Int vector3IntValue { get => (Vector3Int)Value!; set => Value = value; }
    public Quaternion quaternionValue { get => (Quaternion)Value!; set => Value = value; }
    public Color colorValue { get => (Color)Value!; set => Value = value; }
    public Bounds boundsValue { get => (Bounds)Value!; set => Value = value; }
    public Rect rectValue { get => (Rect)Value!; set => Value = value; }

    public long longValue
    {
        get => Value is LayerMask mask ? mask.value : Convert.ToInt64(Value);
        set => Value = ValueType == typeof(LayerMask) ? (LayerMask)(int)value
            : ValueType.IsEnum ? Enum.ToObject(ValueType, value) : Convert.ChangeType(value, ValueType);
    }

    public double doubleValue
    {
        get => Convert.ToDouble(Value);
        set => Value = Convert.ChangeType(value, ValueType);
    }

    public string[] enumNames => Enum.GetNames(ValueType);
    public string[] enumDisplayNames => Array.ConvertAll(enumNames, ObjectNames.NicifyVariableName);
    public int enumValueFlag { get => intValue; set => intValue = value; }

    public int enumValueIndex
    {
        get => Array.IndexOf(Enum.GetValues(ValueType), Value);
        set => Value = Enum.GetValues(ValueType).GetValue(value);
    }

    public bool isArray => SerializedFields.ElementType(ValueType) is not null;

    public int arraySize
    {
        get => (Value as IList)?.Count ?? 0;
        set
        {
            Type element = SerializedFields.ElementType(ValueType)!;
            IList? old = Value as IList;
            Array copy = Array.CreateInstance(element, value);
            for (int i = 0; i < value; i++)
            {
                // A new element repeats the last one, as in an inspector.
                object? item = old is { Count: > 0 } ? old[Math.Min(i, old.Count - 1)] : Default(element);
                copy.SetValue(i < (old?.Count ?? 0) ? item : new Cloner().CopyValue(item, element), i);
            }
            Value = ValueType.IsArray ? copy : Activator.CreateInstance(ValueType, copy);
        }
    }

    public SerializedProperty GetArrayElementAtIndex(int index) => Find(serializedObject, $"{m_Path}.Array.data[{index}]")!;
    public void ClearArray() => arraySize = 0;

    public void InsertArrayElementAtIndex(int index)
    {
        arraySize++;
        var list = (IList)Value!;
        object? item = list[^1];
        for (int i = list.Count - 1; i > index; i--) list[i] = list[i - 1];
        list[index] = index > 0 ? list[index - 1] : item;
        serializedObject.SetRoot(PropertyPath.Split(m_Path)[0], PropertyPath.Get(serializedObject, PropertyPath.Split(m_Path)[0]));
    }

    public void DeleteArrayElementAtIndex(int index)
    {
        var list = (IList)Value!;
        for (int i = index; i < list.Count - 1; i++) list[i] = list[i + 1];
        arraySize = list.Count - 1;
    }

    static object? Default(Type type) =>
        type == typeof(string) ? "" : typeof(Object).IsAssignableFrom(type) ? null : Activator.CreateInstance(type, nonPublic: true);
}
