using System;
using System.Reflection;

namespace UnityEngine.Events;

/// <summary>Listeners added from code. Persistent listeners (set in an inspector) are not part of this stand-in.</summary>
[Serializable]
public abstract class UnityEventBase : ISerializationCallbackReceiver
{
    protected UnityEventBase() { }

    internal abstract void RemoveAllListenersCore();

    public int GetPersistentEventCount() => 0;
    public void RemoveAllListeners() => RemoveAllListenersCore();
    void ISerializationCallbackReceiver.OnBeforeSerialize() { }
    void ISerializationCallbackReceiver.OnAfterDeserialize() { }
}
