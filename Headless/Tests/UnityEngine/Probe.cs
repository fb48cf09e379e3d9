using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Writes each message it gets; private, as scripts usually declare them.</summary>
public class Probe : MonoBehaviour
{
    void Awake() => Write("Awake");
    void OnEnable() => Write("OnEnable");
    void Start() => Write("Start");
    void FixedUpdate() => Write("FixedUpdate");
    void Update() => Write("Update");
    void LateUpdate() => Write("LateUpdate");
    void OnDisable() => Write("OnDisable");
    void OnDestroy() => Write("OnDestroy");
    void OnApplicationQuit() => Write("Quit");

    protected void Write(string message) => EngineFixture.Calls.Add($"{name}.{message}");
}
