using UnityEngine;
using UnityEngine.Events;

namespace Headless.Tests.Importers;

/// <summary>An object with events, and with methods that a scene can name as their listeners.</summary>
public sealed class EventProbe : MonoBehaviour
{
    public static readonly List<string> Log = [];

    public FloatEvent onFloat = new();
    public UnityEvent onNothing = new();

    [Serializable]
    public sealed class FloatEvent : UnityEvent<float>;

    public void Nothing() => Log.Add(name + " nothing");

    public void Float(float value) => Log.Add($"{name} float {value}");

    public void Int(int value) => Log.Add($"{name} int {value}");

    public void Text(string value) => Log.Add($"{name} text {value}");

    public void Flag(bool value) => Log.Add($"{name} flag {value}");

    public void Thing(UnityEngine.Object value) => Log.Add($"{name} thing {value.name}");

    public void Fails() => throw new InvalidOperationException("as asked");
}
