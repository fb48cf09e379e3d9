using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public sealed partial class GameObject
{
    public void SetActive(bool value)
    {
        CheckAlive();
        if (m_ActiveSelf == value) return;
        m_ActiveSelf = value;
        RefreshHierarchy();
    }

    /// <summary>Recomputes activeInHierarchy below here and sends what follows from it, in execution order.</summary>
    internal void RefreshHierarchy()
    {
        if (SceneData is null) return;
        bool active = m_ActiveSelf && (m_Transform.ParentCore is not { } parent || parent.OwnerOrNull!.IsActiveCached);
        if (active == IsActiveCached) return;
        if (active)
        {
            var queue = new AwakeQueue();
            CollectActivated(queue);
            queue.Run();
        }
        else
        {
            Deactivate();
        }
    }

    internal void CollectActivated(AwakeQueue queue)
    {
        if (!m_ActiveSelf || IsActiveCached) return;
        IsActiveCached = true;
        queue.AddRange(m_Components);
        foreach (Transform child in m_Transform.ChildrenSnapshot()) child.OwnerOrNull!.CollectActivated(queue);
    }

    internal void Deactivate()
    {
        if (!IsActiveCached) return;
        IsActiveCached = false;
        foreach (Component component in m_Components.ToArray())
            if (component.IsAlive) component.OnDeactivated();
        foreach (Transform child in m_Transform.ChildrenSnapshot()) child.OwnerOrNull!.Deactivate();
    }
}
