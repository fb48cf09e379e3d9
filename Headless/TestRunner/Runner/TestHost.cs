using UnityEngine;

namespace Headless.Engine;

/// <summary>Carries test coroutines in play mode; survives scene loads and is not found by scene searches.</summary>
sealed class TestHost : MonoBehaviour
{
    static TestHost? s_Host;

    public static TestHost Get()
    {
        if (s_Host) return s_Host!;
        var owner = new GameObject("Code-based tests runner") { hideFlags = HideFlags.HideAndDontSave };
        s_Host = owner.AddComponent<TestHost>();
        DontDestroyOnLoad(owner);
        return s_Host;
    }
}
