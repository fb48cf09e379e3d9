using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public sealed partial class GameObject
{
    public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

    public Component AddComponent(Type componentType)
    {
        CheckAlive();
        return ComponentAdder.Add(this, componentType)!;
    }

    /// <summary>Creates and attaches without lifecycle, requirements or messages: for loaders and copies.</summary>
    internal Component AddComponentRaw(Type type)
    {
        Component component = ObjectCreation.NewComponent(type);
        component.Attach(this);
        m_Components.Add(component);
        return component;
    }

    public T GetComponent<T>()
    {
        CheckAlive();
        foreach (Component component in m_Components)
            if (component is T match) return match;
        return default!;
    }

    public Component GetComponent(Type type)
    {
        CheckAlive();
        foreach (Component component in m_Components)
            if (type.IsInstanceOfType(component)) return component;
        return null!;
    }

    public Component GetComponent(string type)
    {
        CheckAlive();
        foreach (Component component in m_Components)
            if (component.GetType().Name == type || component.GetType().FullName == type) return component;
        return null!;
    }

    public bool TryGetComponent<T>(out T component)
    {
        component = GetComponent<T>();
        return component is not null;
    }

    public bool TryGetComponent(Type type, out Component component)
    {
        component = GetComponent(type);
        return component is not null;
    }

    public T[] GetComponents<T>()
    {
        var list = new List<T>();
        GetComponents(list);
        return list.ToArray();
    }

    public void GetComponents<T>(List<T> results)
    {
        CheckAlive();
        results.Clear();
        Collect(results);
    }

    public Component[] GetComponents(Type type)
    {
        var list = new List<Component>();
        GetComponents(type, list);
        return list.ToArray();
    }

    public void GetComponents(Type type, List<Component> results)
    {
        CheckAlive();
        results.Clear();
        foreach (Component component in m_Components)
            if (type.IsInstanceOfType(component)) results.Add(component);
    }

    public int GetComponentCount() { CheckAlive(); return m_Components.Count; }
    public int GetComponentIndex(Component component) { CheckAlive(); return m_Components.IndexOf(component); }
    public Component GetComponentAtIndex(int index) { CheckAlive(); return m_Components[index]; }
    public T GetComponentAtIndex<T>(int index) where T : Component => (T)GetComponentAtIndex(index);

    internal void Collect<T>(List<T> results)
    {
        foreach (Component component in m_Components)
            if (component is T match) results.Add(match);
    }
}
