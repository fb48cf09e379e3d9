using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>A progress bar with a Cancel button for liquids that take long to come to rest.</summary>
    internal sealed class StartProgressBar : IFluidStartWatcher
    {
        private const double SilentSeconds = 1.0;

        private bool shown;

        [InitializeOnLoadMethod]
        private static void Install()
        {
            if (!Application.isBatchMode) FluidSimulation.EditorWatcher = new StartProgressBar();
        }

        public bool Continue(FluidSimulation simulation, FluidStartProgress progress)
        {
            if (progress.Seconds < SilentSeconds) return true;
            shown = true;
            return !EditorUtility.DisplayCancelableProgressBar("Fluid Simulation",
                $"'{simulation.name}' comes to rest: {progress.Steps} steps, about {Mathf.CeilToInt((float)progress.SecondsLeft)} s left",
                progress.Share);
        }

        public void Ended(FluidSimulation simulation)
        {
            if (shown) EditorUtility.ClearProgressBar();
            shown = false;
        }
    }
}
