using System;
using System.Reflection;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Static methods of scripts that the engine calls because of an attribute.</summary>
static class StaticMethods
{
    /// <summary>Calls those of the project's assemblies whose attribute is chosen, whatever their access.</summary>
    /// <param name="chosen">Whether the attribute asks for a call now.</param>
    public static void Call<T>(Predicate<T> chosen) where T : Attribute
    {
        const BindingFlags statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        foreach (Assembly assembly in EngineState.ScriptAssemblies)
            foreach (Type type in TypeLookup.Types(assembly))
            {
                if (type.ContainsGenericParameters) continue;
                foreach (MethodInfo method in type.GetMethods(statics))
                    if (method.GetCustomAttribute<T>(false) is { } attribute && chosen(attribute)) Call<T>(method);
            }
    }

    static void Call<T>(MethodInfo method)
    {
        if (method.GetParameters().Length > 0 || method.ContainsGenericParameters)
        {
            string name = typeof(T).Name;
            Debug.LogError($"[{name[..^"Attribute".Length]}] {method.DeclaringType}.{method.Name} must be static without parameters.");
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
