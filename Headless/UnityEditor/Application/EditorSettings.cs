using Headless.Engine;

namespace UnityEditor;

/// <summary>The part of ProjectSettings/EditorSettings.asset that says how play mode is entered.</summary>
public sealed class EditorSettings : UnityEngine.Object
{
    private EditorSettings() { }

    public static bool enterPlayModeOptionsEnabled => EngineState.EnterPlayModeOptions.HasValue;
    public static EnterPlayModeOptions enterPlayModeOptions => (EnterPlayModeOptions)(EngineState.EnterPlayModeOptions ?? 0);
}
