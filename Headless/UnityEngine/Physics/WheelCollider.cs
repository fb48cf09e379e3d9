namespace UnityEngine;

/// <summary>
/// The wheel without a vehicle: it hangs at the end of its suspension, steers and turns at <see cref="rotationSpeed"/>. Overlap queries
/// do not find it, as Unity's documentation promises no shape but a ray.
/// </summary>
public class WheelCollider : Collider
{
    float m_RotationSpeed;
    float m_Turned;
    float m_Since;

    public Vector3 center { get; set; }
    public float radius { get; set; } = 0.5f;
    public float suspensionDistance { get; set; } = 0.3f;
    public float mass { get; set; } = 20f;

    /// <summary>[°] about the object's y axis.</summary>
    public float steerAngle { get; set; }

    /// <summary>[°/s] about the axle.</summary>
    public float rotationSpeed
    {
        get => m_RotationSpeed;
        set
        {
            (m_Turned, m_Since, m_RotationSpeed) = (Turned, Time.fixedTime, value);
        }
    }

    public float rpm => m_RotationSpeed / 6f;

    public bool isGrounded => false;

    float Turned => Mathf.Repeat(m_Turned + m_RotationSpeed * (Time.fixedTime - m_Since), 360f);

    public void GetWorldPose(out Vector3 pos, out Quaternion quat)
    {
        float drop = suspensionDistance * Mathf.Abs(transform.lossyScale.y);
        pos = transform.TransformPoint(center) - drop * transform.up;
        quat = transform.rotation * Quaternion.Euler(0f, steerAngle, 0f) * Quaternion.Euler(Turned, 0f, 0f);
    }
}
