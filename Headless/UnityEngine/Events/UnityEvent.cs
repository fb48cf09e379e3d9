using System;

namespace UnityEngine.Events;

[Serializable]
public class UnityEvent : UnityEventBase
{
    UnityAction? m_Calls;

    public void AddListener(UnityAction call) => m_Calls += call;
    public void RemoveListener(UnityAction call) => m_Calls -= call;
    public void Invoke()
    {
        InvokePersistent([], []);
        m_Calls?.Invoke();
    }

    internal override void RemoveAllListenersCore() => m_Calls = null;
}
