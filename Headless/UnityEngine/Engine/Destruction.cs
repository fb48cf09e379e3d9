using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Engine;

/// <summary>Destroy (end of the update) and DestroyImmediate: OnDisable for the whole hierarchy, then OnDestroy, then death.</summary>
static class Destruction
{
    static readonly List<(Object Target, double Time)> s_Pending = new();

    public static void Schedule(Object target, float delay) =>
        s_Pending.Add((target, delay > 0f ? Time.timeAsDouble + delay : double.NegativeInfinity));

    public static void Flush()
    {
        for (int guard = 0; guard < 1000; guard++)
        {
            int index = s_Pending.FindIndex(p => p.Time <= Time.timeAsDouble);
            if (index < 0) return;
            Object target = s_Pending[index].Target;
            s_Pending.RemoveAt(index);
            if (target.IsAlive) Now(target);
        }
    }

    public static void Clear() => s_Pending.Clear();

    public static bool MayRemove(Component component)
    {
        if (component is Transform)
        {
            Debug.LogError($"Can't destroy Transform component of '{component.name}'. If you want to destroy the game object, please call 'Destroy' on the game object instead. Destroying the transform component is not allowed.", component);
            return false;
        }
        foreach (Component other in component.gameObject.ComponentList)
        {
            if (ReferenceEquals(other, component) || !Needs(other.GetType(), component)) continue;
            Debug.LogError($"Can't remove {component.GetType().Name} because {other.GetType().Name} (Script) depends on it", component);
            return false;
        }
        return true;
    }

    static bool Needs(Type dependent, Component component)
    {
        foreach (RequireComponent required in dependent.GetCustomAttributes<RequireComponent>(true))
            foreach (Type? type in new[] { required.m_Type0, required.m_Type1, required.m_Type2 })
                if (type is not null && type.IsInstanceOfType(component) && CountOf(component.gameObject, type) <= 1 && !IsPending(dependent, component)) return true;
        return false;
    }

    static int CountOf(GameObject owner, Type type)
    {
        int count = 0;
        foreach (Component component in owner.ComponentList)
            if (type.IsInstanceOfType(component)) count++;
        return count;
    }

    // A dependent that is already going to die does not keep what it needs.
    static bool IsPending(Type dependent, Component component)
    {
        foreach (Component other in component.gameObject.ComponentList)
            if (other.GetType() == dependent && s_Pending.Exists(p => ReferenceEquals(p.Target, other))) return true;
        return false;
    }

    public static void Now(Object target)
    {
        switch (target)
        {
            case GameObject gameObject:
                gameObject.Deactivate();
                Destroy(gameObject);
                break;
            case Component component:
                component.RemoveFromScene();
                Destroy(component);
                component.OwnerOrNull!.ComponentList.Remove(component);
                break;
            default:
                target.Kill();
                break;
        }
    }

    static void Destroy(GameObject gameObject)
    {
        foreach (Component component in gameObject.ComponentList.ToArray())
            if (component is not Transform && component.IsAlive) component.OnDestroying();
        foreach (Transform child in gameObject.TransformCore.ChildrenSnapshot())
            if (child.IsAlive) Destroy(child.OwnerOrNull!);
        foreach (Component component in gameObject.ComponentList.ToArray())
        {
            if (component is Transform transform) transform.DetachFromParent();
            component.Kill();
        }
        gameObject.Kill();
    }

    static void Destroy(Component component)
    {
        if (!component.IsAlive) return;
        component.OnDestroying();
        component.Kill();
    }
}
