using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Moves this object to and fro along x, gently from rest: its collider makes waves.</summary>
    public sealed class Paddle : MonoBehaviour
    {
        [SerializeField, Min(0f), Tooltip("Half the distance from one end to the other [m].")]
        private float stroke = 0.07f;

        [SerializeField, Min(0f), Tooltip("Strokes to and fro a second [1/s].")]
        private float frequency = 0.9f;

        [SerializeField, Min(0f), Tooltip("How long it rests at first [s].")]
        private float rest = 0.5f;

        private Vector3 middle;
        private float time;

        private void Start() => middle = transform.position;

        private void Update()
        {
            time += Time.deltaTime;
            float strokes = frequency * Mathf.Max(0f, time - rest);
            float gentle = Mathf.SmoothStep(0f, 1f, strokes);
            transform.position = middle + gentle * stroke * Mathf.Sin(2f * Mathf.PI * strokes) * Vector3.right;
        }
    }
}
