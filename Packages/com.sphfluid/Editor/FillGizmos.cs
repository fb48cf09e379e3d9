using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// The particles of a start as points in the Scene view, and the places where vessels leak, of the simulations that an inspector looks
    /// at.
    /// </summary>
    internal static class FillGizmos
    {
        private const float Arm = 0.18f; // of the spacing, where all particles are shown
        private const float LeakSize = 3f; // of the spacing

        private static readonly Color LeakColor = new Color(1f, 0.25f, 0.2f, 1f);
        [OutlivesPlay("inspectors forget what they show")]
        private static readonly Dictionary<FluidSimulation, PreviewMemory> Known = new Dictionary<FluidSimulation, PreviewMemory>();
        [OutlivesPlay("nothing is drawn in play")] private static FillPoints drawn;
        [OutlivesPlay("nothing is drawn in play")] private static Vector3[] segments;

        /// <summary>What is known of a simulation's start is shown while the simulation or one of its volumes is selected.</summary>
        public static void Show(FluidSimulation simulation, PreviewMemory memory) => Known[simulation] = memory;

        /// <summary>It is not known any more.</summary>
        public static void Forget(FluidSimulation simulation, PreviewMemory memory)
        {
            if (Known.TryGetValue(simulation, out PreviewMemory shown) && shown == memory) Known.Remove(simulation);
        }

        /// <summary>Draws the start of a selected simulation, or of the one that a selected volume belongs to.</summary>
        public static void Draw(FluidSimulation simulation)
        {
            if (simulation == null || Application.isPlaying || !Known.TryGetValue(simulation, out PreviewMemory memory)) return;
            Gizmos.matrix = simulation.LocalToWorld;
            if (memory.Points != null)
            {
                if (memory.Points != drawn) (drawn, segments) = (memory.Points, Crosses(memory.Points, simulation.Spacing));
                Gizmos.color = FluidGizmos.VolumeColor;
                Gizmos.DrawLineList(segments);
            }
            Gizmos.color = LeakColor;
            foreach (Vector3 leak in memory.Leaks)
            {
                Gizmos.DrawWireSphere(leak, LeakSize * simulation.Spacing);
                Gizmos.DrawLine(leak,
                    leak +
                        4f * LeakSize * simulation.Spacing *
                            simulation.transform.InverseTransformDirection(-simulation.EffectiveGravity.normalized));
            }
        }

        /// <summary>What the inspector says about the points; null where there are none.</summary>
        public static string Text(PreviewMemory memory)
        {
            if (memory.IsCancelled) return "Filling the liquid was cancelled. It is filled again after the next change.";
            if (memory.Waits) return "The liquid is filled again when nothing changes any more.";
            if (memory.Points == null || memory.Points.Total == 0) return null;
            int shown = memory.Points.Shown.Count, total = memory.Points.Total;
            string share = shown == total ? System.FormattableString.Invariant($"all {total:N0} particles")
                : System.FormattableString.Invariant($"{shown:N0} of {total:N0} particles, evenly chosen");
            return $"The Scene view shows {share}{(memory.IsRelaxed ? ", after they came to rest" : "")}.";
        }

        /// <summary>Ends of the lines of a cross at each point.</summary>
        internal static Vector3[] Crosses(FillPoints points, float spacing)
        {
            float arm = Arm * spacing * Mathf.Pow(points.Total / Mathf.Max(1f, points.Shown.Count), 1f / 3f);
            var ends = new Vector3[6 * points.Shown.Count];
            for (int i = 0; i < points.Shown.Count; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    Vector3 away = Vector3.zero;
                    away[axis] = arm;
                    (ends[6 * i + 2 * axis], ends[6 * i + 2 * axis + 1]) = (points.Shown[i] - away, points.Shown[i] + away);
                }
            }
            return ends;
        }
    }
}
