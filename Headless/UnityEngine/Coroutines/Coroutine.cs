using System.Collections;
using Headless.Engine;

namespace UnityEngine;

public sealed class Coroutine : YieldInstruction
{
    internal Coroutine(MonoBehaviour owner, IEnumerator routine, string? methodName)
    {
        Owner = owner;
        Routine = routine;
        MethodName = methodName;
    }

    internal MonoBehaviour Owner { get; }
    internal IEnumerator Routine { get; }
    internal string? MethodName { get; }
    internal WaitKind Wait { get; set; }
    internal double ResumeTime { get; set; }
    internal long YieldedAt { get; set; }
    internal AsyncOperation? Operation { get; set; }
    internal Coroutine? Nested { get; set; }
    internal Coroutine? Waiter { get; set; }
    internal bool Done { get; set; }
}
