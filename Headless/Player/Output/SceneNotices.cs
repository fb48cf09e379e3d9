using Headless.Engine;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Player.Output;

/// <summary>What makes pictures of a scene empty or dark, in words: in the Editor one would see it.</summary>
internal static class SceneNotices
{
    /// <summary>Looks at the scene after its first frame.</summary>
    public static void Write(Action<LogType, string> console)
    {
        if (!CameraList.Ordered.Any(c => c.isActiveAndEnabled && c.targetTexture == null))
            console(LogType.Warning, "[Player] No camera of the scene is enabled, so the pictures show nothing. Add one (GameObject > Camera), or play with --no-images.");
        else if (!Object.FindObjectsByType<Light>(FindObjectsSortMode.None).Any(l => l.isActiveAndEnabled))
            console(LogType.Log, "[Player] No light of the scene is enabled: there is ambient light only. Add one: GameObject > Light > Directional Light.");
    }
}
