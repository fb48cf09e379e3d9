using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Drops a cube of water into the tank every second. After the tenth it loads what it saved at the start, and begins anew.
    /// </summary>
    public sealed class DropWater : MonoBehaviour
    {
        private const int Most = 10;

        [SerializeField] private FluidSimulation tank;
        [SerializeField] private SaveAndLoad saved;
        private int drops = -1; // not saved yet

        private void Update()
        {
            if (!tank.IsRunning || tank.SimulatedTime < drops + 0.5) return;
            if (drops < 0) saved.Save();
            else if (drops == Most) saved.Load();
            else tank.AddLiquid(transform.position, 0.2f * Vector3.one, transform.rotation);
            drops = drops == Most ? 0 : drops + 1;
        }
    }
}
