using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Notes the events of OnGUI and paints what a test asks for.</summary>
internal sealed class GuiProbe : MonoBehaviour
{
    public System.Action? OnPaint { get; set; }

    public static GuiProbe Create() => new GameObject("Gui").AddComponent<GuiProbe>();

    void OnGUI()
    {
        EngineFixture.Calls.Add(Event.current.type.ToString());
        if (Event.current.type == EventType.Repaint) OnPaint?.Invoke();
    }
}
