using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>How kernels of any kind find neighbours in the published particles: the globals of Shaders/Solver/FluidGrid.hlsl and GridNeighbours.hlsl.</summary>
    internal static class GridNeighbours
    {
        static readonly int GridOrigin = Shader.PropertyToID("_GridOrigin");
        static readonly int CellSize = Shader.PropertyToID("_CellSize");
        static readonly int GridCounts = Shader.PropertyToID("_GridCounts");
        static readonly int SmoothLengthSquared = Shader.PropertyToID("_SmoothLengthSquared");
        static readonly int DensityCoefficient = Shader.PropertyToID("_DensityCoefficient");

        // Shaders/Solver/GridNeighbours.hlsl has both searches.
        static readonly int CellsOfSmoothLength = Shader.PropertyToID("_CellsOfH");

        // Copied when recorded, so one array serves; command buffers are recorded on the main thread.
        static readonly int[] Counts = new int[3];

        public static void SetGrid(CommandBuffer cmd, ComputeKernel kernel, in FluidGrid grid)
        {
            Vector3Int counts = grid.Counts;
            Counts[0] = counts.x;
            Counts[1] = counts.y;
            Counts[2] = counts.z;
            kernel.SetVector(cmd, GridOrigin, grid.Origin);
            kernel.SetVector(cmd, CellSize, grid.CellSize);
            kernel.SetInts(cmd, GridCounts, Counts);
        }

        public static void Set(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            FluidSolverSettings settings = state.Settings;
            double h = settings.SupportRadius;
            SetGrid(cmd, kernel, state.Grid);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            kernel.SetBool(cmd, CellsOfSmoothLength, !settings.OctantSearch);
            kernel.SetFloat(cmd, SmoothLengthSquared, (float)(h * h));
            kernel.SetFloat(cmd, DensityCoefficient, (float)(settings.ParticleMass * MullerKernels.Poly6Factor(h)));
            kernel.Set(cmd, state.Published.Particles);
            kernel.Set(cmd, state.Published.GridIndices);
        }
    }
}
