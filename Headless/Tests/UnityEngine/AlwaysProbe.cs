using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

[ExecuteAlways]
public class AlwaysProbe : MonoBehaviour
{
    void Reset() => EngineFixture.Calls.Add($"{name}.Reset");
    void OnValidate() => EngineFixture.Calls.Add($"{name}.OnValidate");
    void Awake() => EngineFixture.Calls.Add($"{name}.Awake");
    void OnEnable() => EngineFixture.Calls.Add($"{name}.OnEnable");
    void Start() => EngineFixture.Calls.Add($"{name}.Start");
    void FixedUpdate() => EngineFixture.Calls.Add($"{name}.FixedUpdate");
    void Update() => EngineFixture.Calls.Add($"{name}.Update");
}
