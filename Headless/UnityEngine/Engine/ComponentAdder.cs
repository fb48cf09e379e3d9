using System;
using System.Reflection;
using UnityEngine;

namespace Headless.Engine;

/// <summary>AddComponent: requirements first, uniqueness, then the messages a new component gets.</summary>
static class ComponentAdder
{
    public static Component? Add(GameObject owner, Type type)
    {
        ArgumentNullException.ThrowIfNull(type);
        if (!typeof(Component).IsAssignableFrom(type) || type.IsAbstract || type.ContainsGenericParameters || type == typeof(Component) || type == typeof(MonoBehaviour))
        {
            Debug.LogError($"Can't add component '{type.Name}' to {owner.name}: it is not a concrete class derived from Component.", owner);
            return null;
        }
        if (typeof(Transform).IsAssignableFrom(type) || IsDuplicate(owner, type))
        {
            Debug.LogError($"Can't add component '{type.Name}' to {owner.name} because such a component is already added to the game object!", owner);
            return null;
        }
        foreach (RequireComponent required in type.GetCustomAttributes<RequireComponent>(true))
        {
            Require(owner, required.m_Type0);
            Require(owner, required.m_Type1);
            Require(owner, required.m_Type2);
        }
        Component component = owner.AddComponentRaw(type);
        component.FitToMesh();
        if (component is MonoBehaviour script && EngineState.IsEditor && !EngineState.IsPlaying)
        {
            script.ScriptType.Invoke(script, "Reset");
            if (script.IsAlive) script.ScriptType.Invoke(script, "OnValidate");
        }
        if (component.IsAlive && owner.IsActiveCached) component.AwakeFromLoad();
        return component;
    }

    static void Require(GameObject owner, Type? type)
    {
        if (type is null || owner.GetComponent(type) is not null) return;
        Add(owner, type);
    }

    static bool IsDuplicate(GameObject owner, Type type)
    {
        for (Type? t = type; t is not null && t != typeof(Component); t = t.BaseType)
            if (t.IsDefined(typeof(DisallowMultipleComponent), false) && owner.GetComponent(t) is not null) return true;
        return false;
    }
}
