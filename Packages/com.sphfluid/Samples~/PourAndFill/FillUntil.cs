using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Pours until a vessel is full: lets an emitter flow, and stops it when the liquid stands at a level.</summary>
    [RequireComponent(typeof(FluidEmitter))]
    public sealed class FillUntil : MonoBehaviour
    {
        [SerializeField, Tooltip("A sensor of kind Level on the bottom of the vessel.")]
        private FluidSensor bottom;

        [SerializeField, Min(0f), Tooltip("Height above the sensor at which it is full [m].")]
        private float level = 0.16f;

        private FluidEmitter emitter;

        /// <summary>Whether the vessel is full.</summary>
        public bool IsFull => bottom.HasValue && bottom.Value >= level;

        /// <summary>Fills it again, once it has been emptied.</summary>
        public void Fill() => emitter.Play();

        private void Awake() => emitter = GetComponent<FluidEmitter>();

        private void Update()
        {
            if (emitter.IsPlaying && IsFull) emitter.Stop();
        }
    }
}
