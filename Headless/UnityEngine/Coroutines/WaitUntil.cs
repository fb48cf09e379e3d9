using System;

namespace UnityEngine;

public sealed class WaitUntil : CustomYieldInstruction
{
    readonly Func<bool> m_Predicate;

    public WaitUntil(Func<bool> predicate) => m_Predicate = predicate;

    public override bool keepWaiting => !m_Predicate();
}
