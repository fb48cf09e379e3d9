using System;

namespace UnityEngine;

public class AsyncOperation : YieldInstruction
{
    Action<AsyncOperation>? m_Completed;
    bool m_Done;

    public bool isDone => m_Done;
    public float progress { get; internal set; }
    public int priority { get; set; }
    public bool allowSceneActivation { get; set; } = true;

    public event Action<AsyncOperation> completed
    {
        add
        {
            if (m_Done) value(this);
            else m_Completed += value;
        }
        remove => m_Completed -= value;
    }

    internal static AsyncOperation Completed()
    {
        var operation = new AsyncOperation();
        operation.Finish();
        return operation;
    }

    internal void Finish()
    {
        if (m_Done) return;
        m_Done = true;
        progress = 1f;
        Action<AsyncOperation>? handlers = m_Completed;
        m_Completed = null;
        handlers?.Invoke(this);
    }
}
