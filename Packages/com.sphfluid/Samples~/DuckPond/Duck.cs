using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Paddles round a small circle beside the place where it starts: with each stroke of its feet it pushes ahead and turns to where it
    /// swims. The liquid does the rest: it carries the duck and slows it down.
    /// </summary>
    [RequireComponent(typeof(Rigidbody))]
    public sealed class Duck : MonoBehaviour
    {
        private const float StrokeTime = 0.8f;

        [SerializeField, Min(0f), Tooltip("Radius of the circle [m]. The duck starts on it, and the middle is on its right.")]
        private float reach = 0.2f;

        [SerializeField, Tooltip("How fast it goes round [degrees/s].")]
        private float lap = 25f;

        [SerializeField, Min(StrokeTime), Tooltip("From one stroke to the next [s].")]
        private float pause = 1.2f;

        [SerializeField, Min(0f), Tooltip("Push of a stroke, at most [N].")]
        private float push = 5f;

        [SerializeField, Min(0f), Tooltip("Torque of a stroke, at most [N m].")]
        private float turn = 0.4f;

        [SerializeField, Min(0f), Tooltip("How far the centre of mass is below the middle [m]; it keeps the duck upright.")]
        private float ballast = 0.07f;

        private Rigidbody body;
        private Vector3 middle, outwards;
        private float time;

        private void Awake()
        {
            body = GetComponent<Rigidbody>();
            body.centerOfMass = ballast * Vector3.down;
            outwards = -reach * transform.right;
            middle = transform.position - outwards;
        }

        private void FixedUpdate()
        {
            time += Time.fixedDeltaTime;
            float stroke = Mathf.Sin(Mathf.PI * Mathf.Clamp01(time % pause / StrokeTime));
            Vector3 way = middle + Quaternion.AngleAxis(lap * time + 60f, Vector3.up) * outwards - body.position;
            way.y = 0f;
            Vector3 ahead = Vector3.ProjectOnPlane(transform.forward, Vector3.up).normalized;
            float angle = Vector3.SignedAngle(ahead, way, Vector3.up);
            body.AddForce(push * stroke * Mathf.Clamp01(way.magnitude / reach) * ahead);
            body.AddTorque(turn * stroke * Mathf.Clamp(angle / 45f, -1f, 1f) * Vector3.up);
        }
    }
}
