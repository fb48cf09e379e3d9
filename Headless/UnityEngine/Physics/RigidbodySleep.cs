using UnityEngine;

namespace Headless.Engine;

/// <summary>PhysX's wake counter: a body whose energy stays below its threshold for 0.4 s falls asleep.</summary>
sealed class RigidbodySleep
{
    const float Patience = 0.4f;

    float m_Left = Patience, m_Energy;

    public bool IsAsleep { get; private set; }

    /// <summary>Kinetic energy over the mass below which a body may sleep [m²/s²].</summary>
    public float Threshold { get; set; } = Physics.sleepThreshold;

    /// <summary>Whether its last step left it more than that.</summary>
    public bool IsMoving => !IsAsleep && m_Energy >= Threshold;

    public void Wake() => (IsAsleep, m_Left) = (false, Patience);

    public void Sleep() => (IsAsleep, m_Energy) = (true, 0f);

    /// <summary>Takes a step into account.</summary>
    /// <returns>Whether the body falls asleep.</returns>
    public bool Pass(Rigidbody body, float step)
    {
        float turning = Vector3.Dot(body.angularVelocity, RigidbodyMotion.TimesInertia(body, body.angularVelocity)) / body.mass;
        m_Energy = 0.5f * (body.velocity.sqrMagnitude + turning);
        m_Left = m_Energy >= Threshold ? Patience : m_Left - step;
        return m_Left <= 0f;
    }
}
