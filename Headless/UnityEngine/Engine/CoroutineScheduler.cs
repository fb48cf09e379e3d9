using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Runs coroutines to their first yield at once, then resumes them in the phase they wait for.</summary>
static class CoroutineScheduler
{
    static readonly List<Coroutine> s_Active = new();

    public static Coroutine Start(MonoBehaviour owner, IEnumerator routine, string? methodName)
    {
        var coroutine = new Coroutine(owner, routine, methodName);
        s_Active.Add(coroutine);
        Advance(coroutine);
        return coroutine;
    }

    public static void Run(WaitKind phase)
    {
        foreach (Coroutine coroutine in s_Active.ToArray())
        {
            if (coroutine.Done || coroutine.Wait != phase || !IsDue(coroutine, phase)) continue;
            Advance(coroutine);
        }
    }

    static bool IsDue(Coroutine coroutine, WaitKind phase) => phase switch
    {
        WaitKind.FixedUpdate => coroutine.YieldedAt < FrameClock.FixedStepCount,
        WaitKind.EndOfFrame => true,
        _ when coroutine.Operation is { } operation => operation.isDone,
        _ => coroutine.YieldedAt < FrameClock.FrameCount && FrameClock.Time >= coroutine.ResumeTime,
    };

    static void Advance(Coroutine coroutine)
    {
        while (!coroutine.Done)
        {
            coroutine.Operation = null;
            coroutine.Nested = null;
            coroutine.ResumeTime = 0.0;
            bool more;
            try
            {
                more = coroutine.Routine.MoveNext();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, coroutine.Owner);
                more = false;
            }
            if (coroutine.Done) return;
            if (!more)
            {
                Finish(coroutine);
                return;
            }
            if (!Park(coroutine, coroutine.Routine.Current)) return;
        }
    }

    // Records what to wait for; true when there is nothing to wait for and the routine goes on at once.
    static bool Park(Coroutine coroutine, object? yielded)
    {
        coroutine.Wait = WaitKind.NextFrame;
        coroutine.YieldedAt = FrameClock.FrameCount;
        switch (yielded)
        {
            case WaitForFixedUpdate:
                coroutine.Wait = WaitKind.FixedUpdate;
                coroutine.YieldedAt = FrameClock.FixedStepCount;
                return false;
            case WaitForEndOfFrame:
                coroutine.Wait = WaitKind.EndOfFrame;
                return false;
            case WaitForSeconds wait:
                coroutine.ResumeTime = FrameClock.Time + wait.Seconds;
                return false;
            case AsyncOperation operation:
                coroutine.Operation = operation;
                return operation.isDone;
            case Coroutine other:
                return ParkOn(coroutine, other);
            case IEnumerator inner:
                Coroutine nested = Start(coroutine.Owner, inner, null);
                bool finished = ParkOn(coroutine, nested);
                if (!finished) coroutine.Nested = nested;
                return finished;
            default:
                return false;
        }
    }

    static bool ParkOn(Coroutine coroutine, Coroutine other)
    {
        if (other.Done) return true;
        if (other.Waiter is not null)
        {
            Debug.LogError("Another coroutine is already waiting for this coroutine! Currently only one coroutine can wait for another coroutine!", coroutine.Owner);
            return false;
        }
        other.Waiter = coroutine;
        coroutine.Wait = WaitKind.Nested;
        return false;
    }

    static void Finish(Coroutine coroutine)
    {
        coroutine.Done = true;
        s_Active.Remove(coroutine);
        (coroutine.Routine as IDisposable)?.Dispose();
        Coroutine? waiter = coroutine.Waiter;
        coroutine.Waiter = null;
        if (waiter is { Done: false }) Advance(waiter);
    }

    public static void Stop(MonoBehaviour owner, Predicate<Coroutine> match)
    {
        foreach (Coroutine coroutine in s_Active.ToArray())
            if (ReferenceEquals(coroutine.Owner, owner) && match(coroutine)) Cancel(coroutine);
    }

    public static void StopAll(MonoBehaviour owner) => Stop(owner, static _ => true);

    static void Cancel(Coroutine coroutine)
    {
        if (coroutine.Done) return;
        coroutine.Done = true;
        s_Active.Remove(coroutine);
        if (coroutine.Nested is { } nested) Cancel(nested);
    }

    public static void Clear() => s_Active.Clear();
}
