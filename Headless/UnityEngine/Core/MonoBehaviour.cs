using System;
using System.Collections;
using System.Threading;
using Headless.Engine;

namespace UnityEngine;

public partial class MonoBehaviour : Behaviour
{
    CancellationTokenSource? m_DestroyToken;

    public bool useGUILayout { get; set; } = true;
    public bool runInEditMode { get; set; }

    public CancellationToken destroyCancellationToken
    {
        get
        {
            CheckAlive();
            return (m_DestroyToken ??= new CancellationTokenSource()).Token;
        }
    }

    public static void print(object message) => Debug.Log(message);

    internal ScriptState Script { get; } = new();

    internal ScriptType ScriptType => Script.Type ??= ScriptType.Of(GetType());

    /// <summary>Messages reach a script in play mode, and in edit mode when it asks for them.</summary>
    internal bool ReceivesMessages => EngineState.IsPlaying || runInEditMode || ScriptType.RunsInEditMode;

    internal override void AwakeFromLoad()
    {
        if (!IsAlive || OwnerOrNull is not { IsActiveCached: true } || !ReceivesMessages) return;
        if (!Script.AwakeCalled)
        {
            Script.AwakeCalled = true;
            // An exception in Awake switches the component off, so that OnEnable and Start are not called.
            if (!ScriptType.Invoke(this, "Awake") && IsAlive) SetEnabledRaw(false);
        }
        if (IsAlive) RefreshActivation();
    }

    internal override void OnAdded()
    {
        if (!ReceivesMessages) return;
        if (!Script.AwakeCalled)
        {
            Script.AwakeCalled = true;
            ScriptType.Invoke(this, "Awake");
            if (!IsAlive || !IsAdded) return;
        }
        Script.EnableCalled = true;
        ScriptSchedule.Add(this);
        ScriptType.Invoke(this, "OnEnable");
    }

    internal override void OnRemoved()
    {
        if (!Script.EnableCalled) return;
        Script.EnableCalled = false;
        ScriptSchedule.Remove(this);
        ScriptType.Invoke(this, "OnDisable");
    }

    internal override void OnDeactivated()
    {
        RemoveFromScene();
        StopAllCoroutines();
    }

    internal override void OnDestroying()
    {
        CoroutineScheduler.StopAll(this);
        ScriptSchedule.CancelInvokes(this, null);
        if (Script.AwakeCalled) ScriptType.Invoke(this, "OnDestroy");
        m_DestroyToken?.Cancel();
    }

    internal override void CopyNativeState(Component source, Cloner cloner)
    {
        SetEnabledRaw(((Behaviour)source).enabled);
        cloner.CopySerialized(source, this);
    }
}
