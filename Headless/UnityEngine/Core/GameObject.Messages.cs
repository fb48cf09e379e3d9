using Headless.Engine;

namespace UnityEngine;

public sealed partial class GameObject
{
    public void SendMessage(string methodName) => SendMessage(methodName, null!, SendMessageOptions.RequireReceiver);
    public void SendMessage(string methodName, object value) => SendMessage(methodName, value, SendMessageOptions.RequireReceiver);
    public void SendMessage(string methodName, SendMessageOptions options) => SendMessage(methodName, null!, options);

    public void SendMessage(string methodName, object value, SendMessageOptions options)
    {
        CheckAlive();
        Complain(Deliver(methodName, value), methodName, options);
    }

    public void SendMessageUpwards(string methodName) => SendMessageUpwards(methodName, null!, SendMessageOptions.RequireReceiver);
    public void SendMessageUpwards(string methodName, object value) => SendMessageUpwards(methodName, value, SendMessageOptions.RequireReceiver);
    public void SendMessageUpwards(string methodName, SendMessageOptions options) => SendMessageUpwards(methodName, null!, options);

    public void SendMessageUpwards(string methodName, object value, SendMessageOptions options)
    {
        CheckAlive();
        bool any = false;
        for (Transform? t = m_Transform; t is not null; t = t.ParentCore) any |= t.OwnerOrNull!.Deliver(methodName, value);
        Complain(any, methodName, options);
    }

    public void BroadcastMessage(string methodName) => BroadcastMessage(methodName, null!, SendMessageOptions.RequireReceiver);
    public void BroadcastMessage(string methodName, object parameter) => BroadcastMessage(methodName, parameter, SendMessageOptions.RequireReceiver);
    public void BroadcastMessage(string methodName, SendMessageOptions options) => BroadcastMessage(methodName, null!, options);

    public void BroadcastMessage(string methodName, object parameter, SendMessageOptions options)
    {
        CheckAlive();
        bool any = false;
        foreach (Transform t in GetComponentsInChildren<Transform>(false))
            if (t.IsAlive) any |= t.OwnerOrNull!.Deliver(methodName, parameter);
        Complain(any, methodName, options);
    }

    bool Deliver(string methodName, object? value)
    {
        if (!IsActiveCached) return false;
        bool any = false;
        foreach (Component component in m_Components.ToArray())
            if (component.IsAlive && component is MonoBehaviour script) any |= MessageSender.Send(script, methodName, value);
        return any;
    }

    void Complain(bool received, string methodName, SendMessageOptions options)
    {
        if (!received && options == SendMessageOptions.RequireReceiver)
            Debug.LogError($"SendMessage {methodName} has no receiver!", this);
    }
}
