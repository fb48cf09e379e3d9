using System;

namespace UnityEngine;

public sealed class WaitWhile : CustomYieldInstruction
{
    readonly Func<bool> m_Predicate;

    public WaitWhile(Func<bool> predicate) => m_Predicate = predicate;

    public override bool keepWaiting => m_Predicate();
}
