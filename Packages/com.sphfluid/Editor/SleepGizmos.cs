using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>The bricks of a selected liquid that sleep, in play mode.</summary>
    internal static class SleepGizmos
    {
        private static readonly Color AsleepColor = new Color(0.3f, 0.4f, 0.9f, 0.5f);

        /// <summary>Draws them in simulation space. Reads them back, which waits for the GPU.</summary>
        public static void Draw(FluidSimulation simulation)
        {
            if (!simulation.IsRunning || !(simulation.AsleepShare > 0f)) return;
            Gizmos.color = AsleepColor;
            foreach (Bounds brick in simulation.Solver.State.ReadSleepers()) Gizmos.DrawWireCube(brick.center, brick.size);
        }
    }
}
