using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Life and death only, no updates.</summary>
public class QuietProbe : MonoBehaviour
{
    void Awake() => EngineFixture.Calls.Add($"{name}.Awake");
    void OnEnable() => EngineFixture.Calls.Add($"{name}.OnEnable");
    void Start() => EngineFixture.Calls.Add($"{name}.Start");
    void OnDisable() => EngineFixture.Calls.Add($"{name}.OnDisable");
    void OnDestroy() => EngineFixture.Calls.Add($"{name}.OnDestroy");
}
