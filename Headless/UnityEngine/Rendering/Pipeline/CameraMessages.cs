using UnityEngine;

namespace Headless.Engine;

/// <summary>Messages that cameras send to scripts.</summary>
internal static class CameraMessages
{
    /// <summary>To the scripts on the camera itself.</summary>
    public static void Send(Camera camera, string message)
    {
        foreach (MonoBehaviour script in camera.GetComponents<MonoBehaviour>())
        {
            if (Runs(script))
            {
                script.ScriptType.Invoke(script, message);
            }
        }
    }

    public static void SendToAll(string message)
    {
        foreach (MonoBehaviour script in UnityEngine.Object.FindObjectsByType<MonoBehaviour>(FindObjectsSortMode.InstanceID))
        {
            if (script.ScriptType.Find(message) is not null && Runs(script))
            {
                script.ScriptType.Invoke(script, message);
            }
        }
    }

    public static bool Runs(MonoBehaviour script) =>
        script != null && script.isActiveAndEnabled && (EngineState.IsPlaying || script.ScriptType.RunsInEditMode);
}
