using System.Collections;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class RoutineStart : MonoBehaviour
{
    IEnumerator Start()
    {
        EngineFixture.Calls.Add("begin");
        yield return null;
        EngineFixture.Calls.Add("end");
    }

    void Tick() => EngineFixture.Calls.Add("tick");
}
