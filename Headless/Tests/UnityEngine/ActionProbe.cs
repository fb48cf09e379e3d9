using System;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Runs what a test puts into it.</summary>
public class ActionProbe : MonoBehaviour
{
    public Action? onStart;
    public Action? onFixedUpdate;
    public Action? onUpdate;
    public Action? onLateUpdate;

    void Start() => onStart?.Invoke();
    void FixedUpdate() => onFixedUpdate?.Invoke();
    void Update() => onUpdate?.Invoke();
    void LateUpdate() => onLateUpdate?.Invoke();

    public static ActionProbe Create(string name = "Action") => new GameObject(name).AddComponent<ActionProbe>();
}
