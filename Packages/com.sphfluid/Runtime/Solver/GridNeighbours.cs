using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals that several blocks share: Shaders/Solver/FluidGrid.hlsl and GridNeighbours.hlsl.</summary>
    internal static class GridNeighbours
    {
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
            kernel.SetVector(cmd, FluidShaderIds.GridOrigin, grid.Origin);
            kernel.SetVector(cmd, FluidShaderIds.CellSize, grid.CellSize);
            kernel.SetInts(cmd, FluidShaderIds.GridCounts, Counts);
        }

        public static void SetNeighbours(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            FluidSolverSettings settings = state.Settings;
            double h = settings.SupportRadius;
            SetGrid(cmd, kernel, state.Grid);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            kernel.SetBool(cmd, CellsOfSmoothLength, !settings.OctantSearch);
            kernel.SetFloat(cmd, FluidShaderIds.SmoothLengthSquared, (float)(h * h));
            kernel.SetFloat(cmd, FluidShaderIds.DensityCoefficient, (float)(settings.ParticleMass * ThesisKernels.Poly6Factor(h)));
            kernel.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            kernel.SetBuffer(cmd, FluidShaderIds.GridIndices, state.Buffers.GridIndices);
        }
    }
}
