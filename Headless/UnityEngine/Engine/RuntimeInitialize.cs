using System;
using System.Reflection;
using UnityEngine;

namespace Headless.Engine;

/// <summary>[RuntimeInitializeOnLoadMethod]: static, parameterless, any access.</summary>
static class RuntimeInitialize
{
    public static void Run(RuntimeInitializeLoadType loadType)
    {
        const BindingFlags statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        foreach (Assembly assembly in EngineState.ScriptAssemblies)
            foreach (Type type in TypeLookup.Types(assembly))
            {
                if (type.ContainsGenericParameters) continue;
                foreach (MethodInfo method in type.GetMethods(statics))
                    if (method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>(false)?.loadType == loadType) Call(method);
            }
    }

    static void Call(MethodInfo method)
    {
        if (method.GetParameters().Length > 0 || method.ContainsGenericParameters)
        {
            Debug.LogError($"[RuntimeInitializeOnLoadMethod] {method.DeclaringType}.{method.Name} must be static without parameters.");
            return;
        }
        try
        {
            method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, null, null);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }
}
