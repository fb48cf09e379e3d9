using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.ExceptionServices;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>A script class: its messages by name (any access, inherited too), execution order and attributes.</summary>
sealed class ScriptType
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    static readonly ConcurrentDictionary<Type, ScriptType> s_Types = new();
    static readonly ConcurrentDictionary<Type, int> s_ProjectOrders = new();

    readonly ConcurrentDictionary<string, MethodInfo?> m_Messages = new(StringComparer.Ordinal);
    readonly Type m_Type;

    ScriptType(Type type)
    {
        m_Type = type;
        RunsInEditMode = type.IsDefined(typeof(ExecuteAlways), true) || type.IsDefined(typeof(ExecuteInEditMode), true);
        ExecutionOrder = type.GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;
    }

    public bool RunsInEditMode { get; }
    int ExecutionOrder { get; }

    /// <summary>The project's setting (from the script's .meta) wins over the attribute.</summary>
    public int Order => s_ProjectOrders.TryGetValue(m_Type, out int order) ? order : ExecutionOrder;

    public static ScriptType Of(Type type) => s_Types.GetOrAdd(type, static t => new ScriptType(t));

    public static void SetProjectOrder(Type type, int order) => s_ProjectOrders[type] = order;

    /// <summary>The parameterless message of that name, nearest to the instance's own class first.</summary>
    public MethodInfo? Find(string message) => m_Messages.GetOrAdd(message, FindDeclared);

    MethodInfo? FindDeclared(string message)
    {
        for (Type? t = m_Type; t is not null && t != typeof(MonoBehaviour) && t != typeof(ScriptableObject); t = t.BaseType)
            foreach (MethodInfo method in t.GetMethods(Declared))
                if (method.Name == message && method.GetParameters().Length == 0 && !method.ContainsGenericParameters) return method;
        return null;
    }

    /// <summary>The message with these parameter types, or null.</summary>
    public MethodInfo? Find(string message, params Type[] parameters)
    {
        for (Type? t = m_Type; t is not null && t != typeof(MonoBehaviour); t = t.BaseType)
            if (t.GetMethod(message, Declared, parameters) is { } method) return method;
        return null;
    }

    public Action? Bind(Object target, string message)
    {
        MethodInfo? method = Find(message);
        if (method is null) return null;
        return method.ReturnType == typeof(void)
            ? method.CreateDelegate<Action>(target)
            : () => method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, null, null);
    }

    /// <summary>Calls the message if there is one; false after an exception, which is logged.</summary>
    public bool Invoke(Object target, string message)
    {
        MethodInfo? method = Find(message);
        if (method is null) return true;
        try
        {
            method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, null, null);
            return true;
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, target);
            return false;
        }
    }
}
