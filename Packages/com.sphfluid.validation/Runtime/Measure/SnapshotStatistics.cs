using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What a state of the liquid looks like in numbers.</summary>
    public sealed class SnapshotStatistics
    {
        private SnapshotStatistics()
        {
        }

        /// <summary>Fastest particle [m/s].</summary>
        public double MaxSpeed { get; private set; }

        /// <summary>Root mean square of the speeds [m/s].</summary>
        public double RmsSpeed { get; private set; }

        /// <summary>Mean over the particles of max(0, ρ/ρ0 − 1).</summary>
        public double DensityErrorMean { get; private set; }

        /// <summary>Maximum over the particles of max(0, ρ/ρ0 − 1).</summary>
        public double DensityErrorMax { get; private set; }

        /// <summary>Particles with a position or velocity that is not a finite number.</summary>
        public int NonFiniteCount { get; private set; }

        /// <summary>Particles outside the domain box.</summary>
        public int EscapedCount { get; private set; }

        /// <summary>Mean of the finite positions in world space.</summary>
        internal WorldPoint Centre { get; private set; }

        /// <summary>Kinetic energy ½ Σ m v² [J].</summary>
        public double KineticEnergy { get; private set; }

        /// <summary>Measures a state.</summary>
        /// <param name="snapshot">The particles.</param>
        /// <param name="settings">Domain, rest density and particle mass.</param>
        public static SnapshotStatistics Of(FluidSnapshot snapshot, in FluidSolverSettings settings)
        {
            var result = new SnapshotStatistics();
            Vector3 half = 0.5f * settings.DomainSize;
            double speedSquares = 0, errors = 0, x = 0, y = 0, z = 0;
            for (int i = 0; i < snapshot.Count; i++)
            {
                if (!IsFinite(snapshot.LocalPositions[i]) || !IsFinite(snapshot.Velocities[i]))
                {
                    result.NonFiniteCount++;
                    continue;
                }
                Vector3 local = snapshot.LocalPositions[i];
                if (Math.Abs(local.x) > half.x || Math.Abs(local.y) > half.y || Math.Abs(local.z) > half.z) result.EscapedCount++;
                double speedSquare = snapshot.Velocities[i].sqrMagnitude;
                speedSquares += speedSquare;
                result.MaxSpeed = Math.Max(result.MaxSpeed, Math.Sqrt(speedSquare));
                double error = Math.Max(0.0, snapshot.Densities[i] / (double)settings.RestDensity - 1.0);
                errors += error;
                result.DensityErrorMax = Math.Max(result.DensityErrorMax, error);
                WorldPoint at = snapshot.PositionOf(i);
                (x, y, z) = (x + at.X, y + at.Y, z + at.Z);
            }
            double count = Math.Max(1, snapshot.Count - result.NonFiniteCount);
            result.RmsSpeed = Math.Sqrt(speedSquares / count);
            result.DensityErrorMean = errors / count;
            result.Centre = new WorldPoint(x / count, y / count, z / count);
            result.KineticEnergy = 0.5 * settings.ParticleMass * speedSquares;
            return result;
        }

        private static bool IsFinite(Vector3 v) => !float.IsNaN(v.sqrMagnitude) && !float.IsInfinity(v.sqrMagnitude);
    }
}
