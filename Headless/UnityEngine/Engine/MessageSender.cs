using System;
using System.Collections;
using System.Reflection;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Calls by method name: SendMessage, Invoke, StartCoroutine(string).</summary>
static class MessageSender
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    public static bool Send(MonoBehaviour script, string methodName, object? value)
    {
        MethodInfo? method = FindMethod(script.GetType(), methodName, value is not null);
        if (method is null) return false;
        try
        {
            object? result = Call(method, script, value);
            if (result is IEnumerator routine && EngineState.IsPlaying) script.StartCoroutine(routine);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, script);
        }
        return true;
    }

    public static IEnumerator? CreateRoutine(MonoBehaviour script, string methodName, object? value)
    {
        MethodInfo? method = FindMethod(script.GetType(), methodName, value is not null);
        return method is not null && typeof(IEnumerator).IsAssignableFrom(method.ReturnType) ? (IEnumerator?)Call(method, script, value) : null;
    }

    static object? Call(MethodInfo method, object target, object? value)
    {
        int count = method.GetParameters().Length;
        return method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, count == 0 ? null : new[] { value }, null);
    }

    // A method without parameters also receives a message that carries a value; the value is dropped.
    static MethodInfo? FindMethod(Type type, string name, bool withValue)
    {
        for (Type? t = type; t is not null && t != typeof(MonoBehaviour); t = t.BaseType)
        {
            MethodInfo? plain = null;
            foreach (MethodInfo method in t.GetMethods(Declared))
            {
                if (method.Name != name || method.ContainsGenericParameters) continue;
                int count = method.GetParameters().Length;
                if (count == 1 && withValue) return method;
                if (count == 0) plain = method;
            }
            if (plain is not null) return plain;
        }
        return null;
    }
}
