using UnityEngine;
using UnityEngine.TestTools;

namespace Headless.Tests.UnityEngineApi;

public class CountingTest : MonoBehaviour, IMonoBehaviourTest
{
    public int Frames { get; private set; }
    public bool IsTestFinished => Frames >= 3;

    void Update()
    {
        if (!IsTestFinished) Frames++;
    }
}
