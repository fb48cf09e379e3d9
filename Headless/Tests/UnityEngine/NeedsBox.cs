using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

[RequireComponent(typeof(BoxCollider)), DisallowMultipleComponent]
public class NeedsBox : MonoBehaviour { }
