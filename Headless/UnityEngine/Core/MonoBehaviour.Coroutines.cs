using System;
using System.Collections;
using Headless.Engine;

namespace UnityEngine;

public partial class MonoBehaviour
{
    public Coroutine StartCoroutine(IEnumerator routine)
    {
        if (routine is null) throw new NullReferenceException("routine is null");
        return Begin(routine, null);
    }

    public Coroutine StartCoroutine(string methodName) => StartCoroutine(methodName, null!);

    public Coroutine StartCoroutine(string methodName, object value)
    {
        if (string.IsNullOrEmpty(methodName)) throw new NullReferenceException("methodName is null or empty");
        IEnumerator? routine = MessageSender.CreateRoutine(this, methodName, value);
        if (routine is null)
        {
            Debug.LogError($"Coroutine '{methodName}' couldn't be started! No such method returning IEnumerator on {GetType().Name}.", this);
            return null!;
        }
        return Begin(routine, methodName);
    }

    Coroutine Begin(IEnumerator routine, string? methodName)
    {
        CheckAlive();
        if (OwnerOrNull is not { IsActiveCached: true })
        {
            Debug.LogError($"Coroutine couldn't be started because the the game object '{name}' is inactive!", this);
            return null!;
        }
        return CoroutineScheduler.Start(this, routine, methodName);
    }

    public void StopCoroutine(IEnumerator routine)
    {
        if (routine is null) throw new NullReferenceException("routine is null");
        CoroutineScheduler.Stop(this, c => ReferenceEquals(c.Routine, routine));
    }

    public void StopCoroutine(Coroutine routine)
    {
        if (routine is null) throw new NullReferenceException("routine is null");
        CoroutineScheduler.Stop(this, c => ReferenceEquals(c, routine));
    }

    public void StopCoroutine(string methodName) => CoroutineScheduler.Stop(this, c => c.MethodName == methodName);

    public void StopAllCoroutines() => CoroutineScheduler.StopAll(this);

    public void Invoke(string methodName, float time) => ScriptSchedule.Invoke(this, methodName, time, 0f);

    public void InvokeRepeating(string methodName, float time, float repeatRate)
    {
        if (repeatRate <= 0.00001f && repeatRate != 0f) throw new UnityException("Invoke repeat rate has to be larger than 0.00001F)");
        ScriptSchedule.Invoke(this, methodName, time, repeatRate);
    }

    public void CancelInvoke() => ScriptSchedule.CancelInvokes(this, null);
    public void CancelInvoke(string methodName) => ScriptSchedule.CancelInvokes(this, methodName);
    public bool IsInvoking() => ScriptSchedule.IsInvoking(this, null);
    public bool IsInvoking(string methodName) => ScriptSchedule.IsInvoking(this, methodName);
}
