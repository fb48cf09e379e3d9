using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Components come into being through a GameObject only; one made with 'new' stays dead, with Unity's warning.</summary>
static class ObjectCreation
{
    [ThreadStatic] static Stack<Type>? s_Expected;

    public static bool Allows(Object instance)
    {
        if (instance is not Component) return true;
        if (s_Expected is { Count: > 0 } && s_Expected.Peek() == instance.GetType())
        {
            s_Expected.Pop();
            return true;
        }
        Debug.LogWarning($"You are trying to create a {(instance is MonoBehaviour ? "MonoBehaviour" : "Component")} using the 'new' keyword. " +
            $"This is not allowed. {(instance is MonoBehaviour ? "MonoBehaviours" : "Components")} can only be added using AddComponent(). " +
            $"Alternatively, your script can inherit from ScriptableObject or no base class at all ({instance.GetType().FullName}).");
        return false;
    }

    public static T NewComponent<T>() where T : Component => (T)NewComponent(typeof(T));

    public static Component NewComponent(Type type)
    {
        s_Expected ??= new Stack<Type>();
        int depth = s_Expected.Count;
        s_Expected.Push(type);
        try
        {
            return (Component)Activator.CreateInstance(type, nonPublic: true)!;
        }
        finally
        {
            while (s_Expected.Count > depth) s_Expected.Pop();
        }
    }
}
