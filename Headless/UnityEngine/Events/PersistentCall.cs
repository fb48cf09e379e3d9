using System;
using System.Collections.Generic;
using System.Reflection;
using Object = UnityEngine.Object;

namespace UnityEngine.Events;

/// <summary>Listeners set in an inspector; the field names are those of Unity's files.</summary>
[Serializable]
sealed class PersistentCallGroup
{
    [SerializeField] List<PersistentCall> m_Calls = new();

    public int Count => m_Calls.Count;

    public PersistentCall this[int index] => m_Calls[index];

    public void Invoke(object?[] arguments, Type[] types)
    {
        foreach (PersistentCall call in m_Calls) call.Invoke(arguments, types);
    }
}

/// <summary>A method of an object. One whose target is gone or has no such method is passed over, as Unity does.</summary>
[Serializable]
sealed class PersistentCall
{
    [SerializeField] Object? m_Target;
    [SerializeField] string m_MethodName = "";
    [SerializeField] PersistentListenerMode m_Mode;
    [SerializeField] ArgumentCache m_Arguments = new();
    [SerializeField] UnityEventCallState m_CallState = UnityEventCallState.RuntimeOnly;

    public Object? Target => m_Target;
    public string MethodName => m_MethodName;
    public UnityEventCallState State => m_CallState;

    public void Invoke(object?[] arguments, Type[] types)
    {
        if (m_Target == null || m_CallState == UnityEventCallState.Off || m_CallState == UnityEventCallState.RuntimeOnly && !Application.isPlaying) return;
        if (m_Mode != PersistentListenerMode.EventDefined) (arguments, types) = m_Arguments.For(m_Mode);
        MethodInfo? method = Find(m_Target.GetType(), types);
        try
        {
            method?.Invoke(m_Target, arguments);
        }
        catch (TargetInvocationException exception) when (exception.InnerException != null)
        {
            System.Runtime.ExceptionServices.ExceptionDispatchInfo.Throw(exception.InnerException);
        }
    }

    MethodInfo? Find(Type type, Type[] types)
    {
        const BindingFlags Any = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
        for (Type? t = type; t != null; t = t.BaseType)
            if (t.GetMethod(m_MethodName, Any | BindingFlags.DeclaredOnly, null, types, null) is { } method) return method;
        return null;
    }
}

/// <summary>The argument that the inspector gives.</summary>
[Serializable]
sealed class ArgumentCache
{
    [SerializeField] Object? m_ObjectArgument;
    [SerializeField] string m_ObjectArgumentAssemblyTypeName = "";
    [SerializeField] int m_IntArgument;
    [SerializeField] float m_FloatArgument;
    [SerializeField] string m_StringArgument = "";
    [SerializeField] bool m_BoolArgument;

    public (object?[] arguments, Type[] types) For(PersistentListenerMode mode) => mode switch
    {
        PersistentListenerMode.Object => ([m_ObjectArgument], [Type.GetType(m_ObjectArgumentAssemblyTypeName) ?? m_ObjectArgument?.GetType() ?? typeof(Object)]),
        PersistentListenerMode.Int => ([m_IntArgument], [typeof(int)]),
        PersistentListenerMode.Float => ([m_FloatArgument], [typeof(float)]),
        PersistentListenerMode.String => ([m_StringArgument], [typeof(string)]),
        PersistentListenerMode.Bool => ([m_BoolArgument], [typeof(bool)]),
        _ => ([], []),
    };
}
