using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Rain from a rectangle round this object: drops at random places, the same in every run.</summary>
    public sealed class Rain : MonoBehaviour
    {
        [SerializeField] private FluidSimulation simulation;

        [SerializeField, Tooltip("Edge lengths of the rectangle along x and z [m].")]
        private Vector2 size = new Vector2(0.7f, 0.7f);

        [SerializeField, Min(0f), Tooltip("Drops a second [1/s].")]
        private float rate = 500f;

        [SerializeField, Min(0f), Tooltip("Speed of the drops downwards [m/s].")]
        private float speed = 3f;

        private readonly System.Random random = new System.Random(1);
        private float due;

        private void Update()
        {
            if (!simulation.IsRunning) return;
            due += rate * Time.deltaTime;
            for (; due >= 1f; due--)
            {
                var offset = new Vector3(size.x * Next(), 0.1f * Next(), size.y * Next());
                Vector3 drop = simulation.Spacing * new Vector3(1f, 3f, 1f); // three particles, one above the other
                simulation.AddLiquid(transform.position + offset, drop, Quaternion.identity, speed * Vector3.down);
            }
        }

        private float Next() => (float)random.NextDouble() - 0.5f;
    }
}
