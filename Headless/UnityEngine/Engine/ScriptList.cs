using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Scripts that get one kind of update, by execution order and then by the time they were enabled.</summary>
sealed class ScriptList
{
    readonly List<MonoBehaviour> m_Scripts = new();

    public void Add(MonoBehaviour script)
    {
        int order = script.ScriptType.Order;
        int index = m_Scripts.Count;
        while (index > 0 && m_Scripts[index - 1].ScriptType.Order > order) index--;
        m_Scripts.Insert(index, script);
    }

    public void Remove(MonoBehaviour script)
    {
        int index = m_Scripts.FindIndex(s => ReferenceEquals(s, script));
        if (index >= 0) m_Scripts.RemoveAt(index);
    }

    public void Clear() => m_Scripts.Clear();

    /// <summary>Calls every script that was enabled when the pass began and still is.</summary>
    public void Run(Func<ScriptState, Action?> select)
    {
        long limit = ScriptSchedule.Sequence;
        foreach (MonoBehaviour script in m_Scripts.ToArray())
        {
            if (!Runs(script, limit)) continue;
            ScriptSchedule.EnsureStarted(script);
            if (!Runs(script, limit)) continue;
            try
            {
                select(script.Script)!();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, script);
            }
        }
    }

    static bool Runs(MonoBehaviour script, long limit) =>
        script.IsAlive && script.Script.EnableCalled && script.Script.Sequence <= limit;
}
