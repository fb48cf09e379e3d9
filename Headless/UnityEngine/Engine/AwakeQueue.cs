using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Components that become active together: engine components first, then scripts by execution order, each Awake then OnEnable.</summary>
sealed class AwakeQueue
{
    readonly List<Component> m_Components = new();

    public void AddRange(IEnumerable<Component> components) => m_Components.AddRange(components);

    public void Run()
    {
        foreach (Component component in m_Components)
            if (component is not MonoBehaviour && component.IsAlive) component.AwakeFromLoad();
        var scripts = new List<(int Order, int Index, MonoBehaviour Script)>();
        foreach (Component component in m_Components)
            if (component is MonoBehaviour script) scripts.Add((script.ScriptType.Order, scripts.Count, script));
        scripts.Sort((a, b) => a.Order != b.Order ? a.Order.CompareTo(b.Order) : a.Index.CompareTo(b.Index));
        foreach (var (_, _, script) in scripts)
            if (script.IsAlive) script.AwakeFromLoad();
    }
}
