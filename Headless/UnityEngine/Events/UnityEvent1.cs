using System;

namespace UnityEngine.Events;

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    UnityAction<T0>? m_Calls;

    public void AddListener(UnityAction<T0> call) => m_Calls += call;
    public void RemoveListener(UnityAction<T0> call) => m_Calls -= call;
    public void Invoke(T0 arg0)
    {
        InvokePersistent([arg0], [typeof(T0)]);
        m_Calls?.Invoke(arg0);
    }

    internal override void RemoveAllListenersCore() => m_Calls = null;
}
