using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Drops a cube of water into the tank every second, ten times.</summary>
    public sealed class DropWater : MonoBehaviour
    {
        [SerializeField] private FluidSimulation tank;
        private int drops;

        private void Update()
        {
            if (!tank.IsRunning || drops == 10 || tank.SimulatedTime < drops + 0.5) return;
            tank.AddLiquid(transform.position, 0.2f * Vector3.one, transform.rotation);
            drops++;
        }
    }
}
