using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Moves this object to and fro along x, gently from rest: its collider makes waves.</summary>
    public sealed class WaveMaker : MonoBehaviour
    {
        [SerializeField, Min(0f), Tooltip("Half the distance from one end to the other [m].")]
        private float stroke = 0.09f;

        [SerializeField, Min(0f), Tooltip("Strokes to and fro a second [1/s].")]
        private float frequency = 0.7f;

        private Vector3 middle;
        private float time;

        private void Start() => middle = transform.position;

        private void Update()
        {
            float gentle = Mathf.SmoothStep(0f, 1f, frequency * time);
            transform.position = middle - gentle * stroke * Mathf.Sin(2f * Mathf.PI * frequency * time) * Vector3.right;
            time += Time.deltaTime;
        }
    }
}
