using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Drives and steers a floating body: the propeller pushes at the stern, turned by the rudder, while it is under water. Set Throttle
    /// and Rudder from the player's input. The liquid does the rest: it carries the hull, slows it down and rolls it.
    /// </summary>
    [RequireComponent(typeof(Rigidbody))]
    public sealed class Boat : MonoBehaviour
    {
        [SerializeField, Tooltip("A sensor of kind Wetness at the propeller.")]
        private FluidSensor propeller;

        [SerializeField, Min(0f), Tooltip("Push at full throttle [N].")]
        private float thrust = 110f;

        [SerializeField, Range(0f, 60f), Tooltip("How far the rudder turns the push [degrees].")]
        private float rudderAngle = 35f;

        private Rigidbody body;

        /// <summary>-1 full astern to 1 full ahead.</summary>
        public float Throttle { get; set; }

        /// <summary>-1 hard to port to 1 hard to starboard.</summary>
        public float Rudder { get; set; }

        private void Awake() => body = GetComponent<Rigidbody>();

        private void FixedUpdate()
        {
            if (!propeller.HasValue || propeller.Value < 0.5f) return;
            Vector3 ahead = Quaternion.AngleAxis(-rudderAngle * Mathf.Clamp(Rudder, -1f, 1f), transform.up) * transform.forward;
            body.AddForceAtPosition(thrust * Mathf.Clamp(Throttle, -1f, 1f) * ahead, propeller.transform.position);
        }
    }
}
