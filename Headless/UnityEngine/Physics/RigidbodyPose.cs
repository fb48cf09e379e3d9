using UnityEngine;

namespace Headless.Engine;

/// <summary>Where physics has a body and where it had it before its last step, apart from where its Transform shows it.</summary>
sealed class RigidbodyPose
{
    readonly Transform m_Transform;
    Vector3 m_Before, m_Seen;
    Quaternion m_TurnBefore, m_SeenTurn;
    bool m_Between;

    public RigidbodyPose(Transform transform)
    {
        m_Transform = transform;
        m_Transform.GetPositionAndRotation(out m_Seen, out m_SeenTurn);
        Put(m_Seen, m_SeenTurn);
    }

    public Vector3 Position { get; private set; }
    public Quaternion Rotation { get; private set; }

    /// <summary>Takes over the Transform where others than physics have moved it.</summary>
    public bool TakeChange()
    {
        m_Transform.GetPositionAndRotation(out Vector3 position, out Quaternion rotation);
        if (position.Equals(m_Seen) && rotation.Equals(m_SeenTurn)) return false;
        (m_Seen, m_SeenTurn, m_Between) = (position, rotation, false);
        Put(position, rotation);
        return true;
    }

    /// <summary>Puts the body there at once: nothing in between is shown.</summary>
    public void Put(Vector3 position, Quaternion rotation)
    {
        (Position, Rotation) = (position, rotation);
        (m_Before, m_TurnBefore) = (position, rotation);
    }

    /// <summary>Begins a step, with the Transform where the body is.</summary>
    public void Begin()
    {
        (m_Before, m_TurnBefore) = (Position, Rotation);
        Show();
    }

    /// <summary>Goes there in a step.</summary>
    public void MoveTo(Vector3 position, Quaternion rotation)
    {
        Show(position, rotation);
        (Position, Rotation) = (m_Seen, m_SeenTurn);
    }

    public void Show()
    {
        if (!IsShown) Show(Position, Rotation);
        m_Between = false;
    }

    /// <summary>Shows it a part of the way through its last step.</summary>
    public void ShowBetween(float part) => ShowElsewhere(Vector3.Lerp(m_Before, Position, part), Quaternion.Slerp(m_TurnBefore, Rotation, part));

    /// <summary>Shows it where its velocities take it.</summary>
    public void ShowAhead(Vector3 displacement, Vector3 turn) =>
        ShowElsewhere(Position + displacement, Quaternion.AngleAxis(turn.magnitude * Mathf.Rad2Deg, turn.normalized) * Rotation);

    /// <summary>Takes back what was shown in between, and whatever others have made of it since.</summary>
    public void Reset()
    {
        if (m_Between) Show(Position, Rotation);
        m_Between = false;
    }

    /// <summary>Does something with the Transform where physics has the body.</summary>
    public void WhereItIs(System.Action action)
    {
        m_Transform.GetLocalPositionAndRotation(out Vector3 position, out Quaternion rotation);
        m_Transform.SetPositionAndRotation(Position, Rotation);
        action();
        m_Transform.SetLocalPositionAndRotation(position, rotation); // with what a script has made of it
    }

    bool IsShown => m_Seen.Equals(Position) && m_SeenTurn.Equals(Rotation);

    void ShowElsewhere(Vector3 position, Quaternion rotation)
    {
        Show(position, rotation);
        m_Between = true;
    }

    void Show(Vector3 position, Quaternion rotation)
    {
        m_Transform.SetPositionAndRotation(position, rotation);
        m_Transform.GetPositionAndRotation(out m_Seen, out m_SeenTurn);
    }
}
