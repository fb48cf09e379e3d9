using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Volume of a liquid at rest: mean height of its columns times their free area, beside the volume that its mass
    /// takes at the densities it has. Gravity must point along the simulation's −y axis.
    /// </summary>
    public readonly struct LiquidVolume
    {
        private LiquidVolume(double measured, double expected)
        {
            Measured = measured;
            Expected = expected;
        }

        /// <summary>
        /// Σ over columns two spacings wide of area × (height of the highest particle + half a spacing − solid below) [m³].
        /// </summary>
        public double Measured { get; }

        /// <summary>Σ m / max(ρ0, ρ_i) [m³]: the equation of state's volume; the surface's missing neighbours do not count.</summary>
        public double Expected { get; }

        /// <summary>Measures a running simulation.</summary>
        public static LiquidVolume Of(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            FluidSolverSettings settings = simulation.Solver.Settings;
            int nx = Columns(settings.DomainSize.x, settings.Spacing), nz = Columns(settings.DomainSize.z, settings.Spacing);
            float[] tops = Tops(snapshot, settings, nx, nz);
            double area = (double)settings.DomainSize.x * settings.DomainSize.z / ((long)nx * nz);
            double measured = 0;
            for (int z = 0; z < nz; z++)
                for (int x = 0; x < nx; x++)
                {
                    measured += area * FreeHeight(simulation.Obstacles, settings, ColumnCentre(settings.DomainSize, x, z, nx, nz),
                        tops[z * nx + x]);
                }

            double expected = 0;
            foreach (float density in snapshot.Densities) expected += settings.ParticleMass / Math.Max(settings.RestDensity, density);
            return new LiquidVolume(measured, expected);
        }

        /// <summary>
        /// Whether columns measure anything: while drops fly, the highest particle of a column says nothing of what is below it. At rest is
        /// a liquid whose motion lifts it by a tenth of a spacing at most, v² / 2g.
        /// </summary>
        /// <param name="rmsSpeed">Root mean square of the particles' speeds [m/s].</param>
        /// <param name="settings">Spacing and gravity.</param>
        public static bool IsAtRest(double rmsSpeed, in FluidSolverSettings settings) =>
            rmsSpeed * rmsSpeed <= 2.0 * settings.Gravity.magnitude * 0.1 * settings.Spacing;

        private static int Columns(float edge, float spacing) => Math.Max(1, Mathf.RoundToInt(edge / (2f * spacing)));

        // Height of the highest particle of each column above the floor, plus half a spacing; zero for an empty column.
        private static float[] Tops(FluidSnapshot snapshot, in FluidSolverSettings settings, int nx, int nz)
        {
            var tops = new float[nx * nz];
            Vector3 size = settings.DomainSize;
            foreach (Vector3 position in snapshot.LocalPositions)
            {
                int x = Mathf.Clamp((int)((position.x / size.x + 0.5f) * nx), 0, nx - 1);
                int z = Mathf.Clamp((int)((position.z / size.z + 0.5f) * nz), 0, nz - 1);
                tops[z * nx + x] = Mathf.Max(tops[z * nx + x], position.y + 0.5f * size.y + 0.5f * settings.Spacing);
            }
            return tops;
        }

        private static Vector2 ColumnCentre(Vector3 size, int x, int z, int nx, int nz) =>
            new Vector2(((x + 0.5f) / nx - 0.5f) * size.x, ((z + 0.5f) / nz - 0.5f) * size.z);

        // The part of a column below its top that no collider fills, by samples half a spacing apart.
        private static double FreeHeight(IReadOnlyList<FluidObstacle> obstacles, in FluidSolverSettings settings, Vector2 column, float top)
        {
            int samples = Mathf.CeilToInt(top / (0.5f * settings.Spacing));
            int free = 0;
            for (int i = 0; i < samples; i++)
            {
                var point = new Vector3(column.x, (i + 0.5f) / samples * top - 0.5f * settings.DomainSize.y, column.y);
                if (!obstacles.Any(o => o.Mesh.Contains(point))) free++;
            }
            return samples == 0 ? 0.0 : (double)top * free / samples;
        }
    }
}
