using System;
using System.Linq;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>GPU memory that a table takes for a number of particles, as all its liquids and surfaces are kept at once.</summary>
    internal static class BenchMemory
    {
        // Of the device's memory; the rest is for the driver, the desktop and what is on its way to the device.
        private const double Share = 0.8;

        // Upper bounds of gpu_bytes in benchmarks/surface-h200-2026-11-26.csv and surface-llvmpipe-2026-11-25.csv: of each cell of a dense
        // grid, of each square of cells across a sparse one, of each particle where the spacing gives the cell, and of any.
        private const double GeometryCell = 4.5, DenseCell = 24.0, SparseSquare = 3000.0, Particle = 260.0, Least = 16e6;

        /// <summary>What a table may take on this device [bytes].</summary>
        public static double Most => Share * SystemInfo.graphicsMemorySize * 1048576.0;

        /// <summary>
        /// What a table takes for a number of particles [bytes]; infinite where a buffer of it is larger than the device allows.
        /// </summary>
        public static double Of(BenchPlan plan, int particles) =>
            plan.Solvers.Sum(solver => OfLiquid(solver, particles)) + plan.ConfigsOf(particles).Sum(config => OfSurface(config, particles));

        private static double OfLiquid(BenchSolver solver, int particles)
        {
            BenchLiquid.Sizes(particles, out float spacing, out float height);
            try
            {
                return GpuLaboratory.PlannedBytes(solver.Settings(spacing, height), particles, solver.HasMesh);
            }
            catch (Exception exception) when (exception is FluidDeviceException || exception is ArgumentException)
            {
                return double.PositiveInfinity;
            }
        }

        private static double OfSurface(BenchConfig config, int particles)
        {
            switch (config.Kind)
            {
                case BenchSurfaceKind.None:
                case BenchSurfaceKind.Particles: return 0.0;
                case BenchSurfaceKind.Geometry: return GeometryCell * Math.Pow(config.Grid, 3.0);
                case BenchSurfaceKind.DenseCompute: return DenseCell * Math.Pow(config.Grid, 3.0);
                default: return Least + SparseSquare * config.Grid * config.Grid + (config.Grid == 0 ? Particle * particles : 0.0);
            }
        }
    }
}
