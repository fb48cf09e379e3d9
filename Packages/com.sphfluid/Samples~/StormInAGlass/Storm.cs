using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Shakes this object round in a circle, gently from rest, and tips it a little: the liquid in it sloshes.</summary>
    public sealed class Storm : MonoBehaviour
    {
        [SerializeField, Min(0f), Tooltip("Radius of the circle [m].")]
        private float stroke = 0.022f;

        [SerializeField, Min(0f), Tooltip("Rounds a second [1/s].")]
        private float frequency = 3.1f;

        [SerializeField, Range(0f, 30f), Tooltip("How far it tips [degrees].")]
        private float tilt = 5f;

        private Vector3 middle;
        private float time;

        private void Start() => middle = transform.position;

        private void Update()
        {
            float gentle = Mathf.SmoothStep(0f, 1f, time), angle = 2f * Mathf.PI * frequency * time;
            float along = gentle * Mathf.Sin(angle), across = gentle * (1f - Mathf.Cos(angle)) * 0.5f;
            transform.SetPositionAndRotation(middle + stroke * new Vector3(along, 0f, across), Quaternion.Euler(0f, 0f, -tilt * along));
            time += Time.deltaTime;
        }
    }
}
