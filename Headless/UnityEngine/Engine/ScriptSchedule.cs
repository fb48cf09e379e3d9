using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Start, FixedUpdate, Update, LateUpdate and Invoke for enabled scripts.</summary>
static class ScriptSchedule
{
    sealed class PendingInvoke
    {
        public required MonoBehaviour Script;
        public required string Method;
        public double Time;
        public float Repeat;
    }

    static readonly ScriptList s_Fixed = new();
    static readonly ScriptList s_Update = new();
    static readonly ScriptList s_Late = new();
    static readonly List<MonoBehaviour> s_Starts = new();
    static readonly List<PendingInvoke> s_Invokes = new();

    public static long Sequence { get; private set; }

    public static void Add(MonoBehaviour script)
    {
        ScriptState state = script.Script;
        state.Sequence = ++Sequence;
        ScriptType type = script.ScriptType;
        if ((state.FixedUpdate ??= type.Bind(script, "FixedUpdate")) is not null) s_Fixed.Add(script);
        if ((state.Update ??= type.Bind(script, "Update")) is not null) s_Update.Add(script);
        if ((state.LateUpdate ??= type.Bind(script, "LateUpdate")) is not null) s_Late.Add(script);
        if (!state.StartCalled) s_Starts.Add(script);
    }

    public static void Remove(MonoBehaviour script)
    {
        s_Fixed.Remove(script);
        s_Update.Remove(script);
        s_Late.Remove(script);
        s_Starts.RemoveAll(s => ReferenceEquals(s, script));
    }

    public static void Clear()
    {
        s_Fixed.Clear();
        s_Update.Clear();
        s_Late.Clear();
        s_Starts.Clear();
        s_Invokes.Clear();
    }

    public static void RunStarts()
    {
        while (s_Starts.Count > 0)
        {
            MonoBehaviour script = s_Starts[0];
            s_Starts.RemoveAt(0);
            EnsureStarted(script);
        }
    }

    public static void EnsureStarted(MonoBehaviour script)
    {
        ScriptState state = script.Script;
        if (state.StartCalled || !script.IsAlive || !state.EnableCalled) return;
        state.StartCalled = true;
        var start = script.ScriptType.Find("Start");
        if (start is null) return;
        try
        {
            object? result = start.Invoke(script, System.Reflection.BindingFlags.DoNotWrapExceptions, null, null, null);
            if (result is IEnumerator routine && script.IsAlive) script.StartCoroutine(routine);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, script);
        }
    }

    public static void FixedUpdate() => s_Fixed.Run(static s => s.FixedUpdate);
    public static void Update() => s_Update.Run(static s => s.Update);
    public static void LateUpdate() => s_Late.Run(static s => s.LateUpdate);

    public static void Invoke(MonoBehaviour script, string method, float delay, float repeat)
    {
        s_Invokes.Add(new PendingInvoke { Script = script, Method = method, Time = FrameClock.Time + Math.Max(delay, 0f), Repeat = repeat });
    }

    public static void CancelInvokes(MonoBehaviour script, string? method) =>
        s_Invokes.RemoveAll(i => ReferenceEquals(i.Script, script) && (method is null || i.Method == method));

    public static bool IsInvoking(MonoBehaviour script, string? method) =>
        s_Invokes.Exists(i => ReferenceEquals(i.Script, script) && (method is null || i.Method == method));

    public static void RunInvokes()
    {
        foreach (PendingInvoke call in s_Invokes.ToArray())
        {
            while (call.Time <= FrameClock.Time && s_Invokes.Contains(call))
            {
                if (call.Repeat > 0f) call.Time += call.Repeat;
                else s_Invokes.Remove(call);
                if (!call.Script.IsAlive)
                {
                    s_Invokes.Remove(call);
                    break;
                }
                if (!MessageSender.Send(call.Script, call.Method, null))
                    Debug.LogError($"Trying to Invoke method: {call.Script.GetType().Name}.{call.Method} couldn't be called.", call.Script);
            }
        }
    }
}
