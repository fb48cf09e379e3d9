using UnityEngine;

namespace Headless.Engine;

/// <summary>OnGUI of all scripts, after the cameras: once to lay out where the script wants that, once to paint.</summary>
static class GuiMessages
{
    public static void Send()
    {
        GuiPicture.Clear();
        Event before = Event.current;
        try
        {
            Send(EventType.Layout);
            Send(EventType.Repaint);
        }
        finally
        {
            Event.current = before;
        }
    }

    static void Send(EventType type)
    {
        foreach (MonoBehaviour script in UnityEngine.Object.FindObjectsByType<MonoBehaviour>(FindObjectsSortMode.InstanceID))
        {
            if (script.ScriptType.Find("OnGUI") is null || !CameraMessages.Runs(script)) continue;
            if (type == EventType.Layout && !script.useGUILayout) continue;
            Event.current = new Event { type = type };
            script.ScriptType.Invoke(script, "OnGUI");
        }
    }
}
