using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Measures in play what steps cost on this device: each liquid until its means are complete, once in a session of play.</summary>
    static class StepCostMeter
    {
        [OutlivesPlay("Restart empties it")] static readonly HashSet<FluidSimulation> Under = new HashSet<FluidSimulation>();
        [OutlivesPlay("Restart empties it")] static readonly HashSet<FluidSimulation> Done = new HashSet<FluidSimulation>();

        /// <summary>Looks at the running liquids.</summary>
        internal static void Look()
        {
            foreach (FluidSimulation simulation in FluidSimulation.Active)
            {
                if (!simulation.IsRunning || Done.Contains(simulation)) continue;
                if (Under.Add(simulation)) simulation.BeginTiming();
                if (simulation.Timer == null || simulation.Timer.FrameCount < StepTimer.Window) continue;
                StepCostWatch.Note(simulation.Timer, simulation.Solver, simulation.Obstacles.Count > 0);
                simulation.EndTiming();
                Under.Remove(simulation);
                Done.Add(simulation);
            }
        }

        /// <summary>A session of play begins or ends.</summary>
        internal static void Restart()
        {
            foreach (FluidSimulation simulation in Under)
                if (simulation != null) simulation.EndTiming();
            Under.Clear();
            Done.Clear();
        }

        [InitializeOnLoadMethod]
        static void Install()
        {
            if (Application.isBatchMode || !StepTimer.IsSupported) return;
            EditorApplication.playModeStateChanged += _ => Restart();
            EditorApplication.update += () =>
            {
                if (Application.isPlaying) Look();
            };
        }
    }
}
