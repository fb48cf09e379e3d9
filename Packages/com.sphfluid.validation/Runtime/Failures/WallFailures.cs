using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What goes wrong at walls and sheets.</summary>
    internal static class WallFailures
    {
        private const float Step = 0.01f;

        /// <summary>
        /// Particles thrown at a fan of four triangles, at faces, edges and vertex, one spacing a step. The swept test cuts the step at the
        /// face; what rounding and gravity add to it puts the particle behind. Cured: 0.3 spacings a step.
        /// </summary>
        public static FailureExperiment Tunnelling() =>
            new FailureExperiment("tunnelling", FluidFailure.Tunnelling, Drop(1f, 9.81f), Drop(0.3f, 9.81f),
            "share of particles behind the sheet", Behind);

        /// <summary>Single particles above the sheet, thrown at it.</summary>
        /// <param name="displacement">Spacings that one moves in a step.</param>
        /// <param name="gravity">g [m/s²].</param>
        public static FailureRun Drop(float displacement, float gravity)
        {
            float dx = FailureBlocks.Spacing;
            FluidSolverSettings settings = FailureBlocks.Settings(new Vector3(4f, 2f, 4f));
            settings.TimeStep = Step;
            settings.Gravity = new Vector3(0f, -gravity, 0f);
            var start = new FluidParticle[49];
            for (int i = 0; i < start.Length; i++)
            {
                // Lone, every 0.4 m: on the diagonals over edges, in the middle over the vertex, over faces else.
                // One step away at least: the first kick, a half, would stop only half of what hits it.
                float height = dx * (displacement + 0.55f + 0.6f * (i * 0.618f % 1f));
                var position = new Vector3(0.4f * (i % 7 - 3), height, 0.4f * (i / 7 - 3));
                start[i] = new FluidParticle(position, new Vector3(0f, -displacement * dx / Step, 0f), (uint)i);
            }
            return new FailureRun { Settings = settings, Start = start, Steps = 20, Sheets = new[] { Fan(1.9f) } };
        }

        /// <summary>Share of particles below the sheet at the end.</summary>
        public static double Behind(FailureResult result) =>
            result.End.LocalPositions.Count(p => p.y < 0f) / (double)result.Run.Start.Length;

        /// <summary>A column on walls a hundredth as stiff as by rule.</summary>
        public static FailureExperiment Stacking()
        {
            FailureRun cured = FailureBlocks.Column(new Vector3Int(6, 10, 6), 9.81f, 25.0, FluidAxes.X | FluidAxes.Z);
            cured.Steps = 150;
            FluidSolverSettings soft = cured.Settings.WithOwn((ref ThesisSettings own) =>
            {
                own.WallStiffness *= 0.01f;
                own.WallDamping *= 0.1f;
            });
            return new FailureExperiment("wall-stacking", FluidFailure.WallStacking, cured.With(soft), cured,
                "share of particles nearer to a wall than dx/10", r => r.EndStatistics.AtWalls / (double)r.Run.Start.Length);
        }

        // A square about the origin, its front up.
        private static Vector3[] Fan(float half)
        {
            Vector3[] corners = { new Vector3(-half, 0f, -half), new Vector3(-half, 0f, half), new Vector3(half, 0f, half),
                new Vector3(half, 0f, -half) };
            return Enumerable.Range(0, 4).SelectMany(i => new[] { Vector3.zero, corners[i], corners[(i + 1) % 4] }).ToArray();
        }
    }
}
