namespace UnityEngine;

public class WaitForSecondsRealtime : CustomYieldInstruction
{
    float m_Until = -1f;

    public WaitForSecondsRealtime(float time) => waitTime = time;

    public float waitTime { get; set; }

    public override bool keepWaiting
    {
        get
        {
            if (m_Until < 0f) m_Until = Time.realtimeSinceStartup + waitTime;
            bool wait = Time.realtimeSinceStartup < m_Until;
            if (!wait) Reset();
            return wait;
        }
    }

    public override void Reset() => m_Until = -1f;
}
