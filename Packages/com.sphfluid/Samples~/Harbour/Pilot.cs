using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Steers a boat from mark to mark: it stands where a game has the player's input.</summary>
    public sealed class Pilot : MonoBehaviour
    {
        [SerializeField] private Boat boat;

        [SerializeField, Tooltip("Where it goes, one after the other.")]
        private Transform[] marks;

        [SerializeField, Range(-1f, 1f)] private float throttle = 1f;

        private int next;

        private void Update()
        {
            Vector3 way = marks[next].position - boat.transform.position;
            way.y = 0f;
            if (way.magnitude < 0.8f) next = (next + 1) % marks.Length;
            float angle = Vector3.SignedAngle(boat.transform.forward, way, Vector3.up);
            boat.Rudder = Mathf.Clamp(angle / 30f, -1f, 1f);
            boat.Throttle = throttle;
        }
    }
}
