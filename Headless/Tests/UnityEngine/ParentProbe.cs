using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public sealed class ParentProbe : MonoBehaviour
{
    public int Times { get; private set; }

    private void OnTransformParentChanged() => Times++;
}
