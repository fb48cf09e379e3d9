using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What ends a run of any case: numbers that are none, liquid beyond walls, speeds that no right answer has.</summary>
    internal sealed class CaseFailure
    {
        // Share of the particles: a splash that leaves is no failure.
        private const double EscapedShare = 1e-3;

        private readonly CaseSetup setup;
        private readonly List<TriangleMesh> obstacles;

        public CaseFailure(CaseSetup setup)
        {
            this.setup = setup;
            obstacles = setup.Obstacles.Select(TriangleMesh.FromCorners).ToList();
        }

        /// <summary>
        /// Why the counts show no liquid any more; null when they do not. The solver stops particles that are not finite.
        /// </summary>
        public static string Of(in FluidCounters counters) => counters.NonFinite > 0
            ? FormattableString.Invariant($"{counters.NonFinite} positions or velocities were not finite") : null;

        /// <summary>Why the state is no liquid any more; null when it is.</summary>
        public string Of(FluidSnapshot state) => Of(state, CaseReadings.None);

        /// <summary>Why the state is no liquid any more, or liquid in a body; null when it is well.</summary>
        public string Of(FluidSnapshot state, CaseReadings readings)
        {
            int lost = 0, stopped = 0;
            double fastest = 0.0;
            Vector3 half = 0.5f * setup.Settings.DomainSize;
            for (int i = 0; i < state.Count; i++)
            {
                Vector3 p = state.LocalPositions[i];
                double speed = state.Velocities[i].magnitude;
                if (!IsFinite(p.sqrMagnitude) || !IsFinite((float)speed))
                {
                    return $"particle {state.Ids[i]} is at {p} m with {state.Velocities[i]} m/s";
                }
                fastest = Math.Max(fastest, speed);
                lost += IsBeyondWall(p, half) || IsInBody(p, readings) ? 1 : 0;
                stopped += setup.IsOpen && IsAtFace(p, half) ? 1 : 0;
            }
            if (lost > EscapedShare * state.Count)
            {
                return FormattableString.Invariant($"{100.0 * lost / state.Count:0.##} % of the particles are beyond a wall by half a ") +
                    "spacing or more";
            }
            if (stopped > EscapedShare * state.Count)
            {
                return FormattableString.Invariant($"{100.0 * stopped / state.Count:0.##} % of the particles flew to the faces of the ") +
                    "domain, which is open";
            }
            if (fastest > setup.SpeedLimit)
            {
                return FormattableString.Invariant($"a particle has {fastest:0.###} m/s, no right answer more than ") +
                    FormattableString.Invariant($"{setup.SpeedLimit:0.###} m/s");
            }
            return null;
        }

        private bool IsBeyondWall(Vector3 p, Vector3 half)
        {
            float depth = 0.5f * setup.Settings.Spacing;
            if (Mathf.Abs(p.x) > half.x + depth || Mathf.Abs(p.y) > half.y + depth || Mathf.Abs(p.z) > half.z + depth) return true;
            foreach (TriangleMesh obstacle in obstacles)
            {
                if (obstacle.Contains(p) && !obstacle.IsNear(p, depth)) return true;
            }
            return false;
        }

        private bool IsInBody(Vector3 p, CaseReadings readings)
        {
            float depth = 0.5f * setup.Settings.Spacing;
            for (int i = 0; i < readings.Bodies.Count; i++)
            {
                TriangleMesh mesh = setup.Bodies[i].Mesh;
                Vector3 own = p - readings.Bodies[i];
                if (mesh.Contains(own) && !mesh.IsNear(own, depth)) return true;
            }
            return false;
        }

        private bool IsAtFace(Vector3 p, Vector3 half)
        {
            Vector3 period = setup.Settings.PeriodLength;
            return (period.x == 0f && Mathf.Abs(p.x) >= half.x) || (period.y == 0f && Mathf.Abs(p.y) >= half.y) ||
                (period.z == 0f && Mathf.Abs(p.z) >= half.z);
        }

        private static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);
    }
}
