using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Keeps this object at the level that a sensor reads.</summary>
    public sealed class WaterMark : MonoBehaviour
    {
        [SerializeField, Tooltip("A sensor of kind Level, upright.")]
        private FluidSensor sensor;

        private void Update()
        {
            if (!sensor.HasValue) return;
            Vector3 place = transform.position;
            place.y = sensor.transform.position.y + sensor.Value;
            transform.position = place;
        }
    }
}
