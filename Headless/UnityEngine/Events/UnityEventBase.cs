using System;

namespace UnityEngine.Events;

/// <summary>Listeners added from code, and those set in an inspector, which are called first.</summary>
[Serializable]
public abstract class UnityEventBase : ISerializationCallbackReceiver
{
    [SerializeField] PersistentCallGroup m_PersistentCalls = new();

    protected UnityEventBase() { }

    internal abstract void RemoveAllListenersCore();

    private protected void InvokePersistent(object?[] arguments, Type[] types)
    {
        if (m_PersistentCalls.Count > 0) m_PersistentCalls.Invoke(arguments, types);
    }

    public int GetPersistentEventCount() => m_PersistentCalls.Count;
    public Object? GetPersistentTarget(int index) => m_PersistentCalls[index].Target;
    public string GetPersistentMethodName(int index) => m_PersistentCalls[index].MethodName;
    public UnityEventCallState GetPersistentListenerState(int index) => m_PersistentCalls[index].State;
    public void RemoveAllListeners() => RemoveAllListenersCore();
    void ISerializationCallbackReceiver.OnBeforeSerialize() { }
    void ISerializationCallbackReceiver.OnAfterDeserialize() { }
}
