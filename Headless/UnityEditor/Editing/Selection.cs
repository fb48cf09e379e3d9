using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class Selection
{
    static Object[] s_Objects = Array.Empty<Object>();

    public static Action? selectionChanged;

    public static Object activeObject
    {
        get => s_Objects.Length > 0 ? s_Objects[0] : null!;
        set => objects = value ? new[] { value } : Array.Empty<Object>();
    }

    public static GameObject activeGameObject
    {
        get => activeObject as GameObject ?? (activeObject as Component)?.gameObject!;
        set => activeObject = value;
    }

    public static Transform activeTransform
    {
        get => activeGameObject ? activeGameObject.transform : null!;
        set => activeObject = value ? value.gameObject : null!;
    }

    public static Object[] objects
    {
        get => Array.FindAll(s_Objects, o => o);
        set
        {
            s_Objects = value ?? Array.Empty<Object>();
            selectionChanged?.Invoke();
        }
    }

    public static GameObject[] gameObjects
    {
        get
        {
            var found = new List<GameObject>();
            foreach (Object item in objects)
                if (item is GameObject gameObject) found.Add(gameObject);
            return found.ToArray();
        }
    }

    public static int count => objects.Length;
    public static bool Contains(Object obj) => Array.IndexOf(objects, obj) >= 0;
}
