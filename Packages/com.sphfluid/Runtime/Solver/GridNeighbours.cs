using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How kernels of any kind find neighbours in the published particles: the globals of Shaders/Solver/FluidGrid.hlsl and
    /// GridNeighbours.hlsl.
    /// </summary>
    internal static class GridNeighbours
    {
        private static readonly int GridOrigin = Shader.PropertyToID("_GridOrigin");
        private static readonly int CellSize = Shader.PropertyToID("_CellSize");
        private static readonly int GridCounts = Shader.PropertyToID("_GridCounts");
        private static readonly int SmoothLengthSquared = Shader.PropertyToID("_SmoothLengthSquared");
        private static readonly int DensityCoefficient = Shader.PropertyToID("_DensityCoefficient");

        private static readonly int ListLength = Shader.PropertyToID("_ListLength");
        private static readonly int Neighbours = Shader.PropertyToID("_Neighbours");
        private static readonly int NeighbourCountsBegin = Shader.PropertyToID("_NeighbourCountsBegin");

        // Shaders/Solver/GridNeighbours.hlsl has both searches.
        private static readonly int CellsOfSmoothLength = Shader.PropertyToID("_CellsOfH");

        // Copied when recorded, so one array serves; command buffers are recorded on the main thread.
        [OutlivesPlay("it is filled anew for each use")] private static readonly int[] Counts = new int[3];

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

        /// <summary>Records a list of neighbours of length 0 for a kernel that can read one: every particle searches.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="kernel">The kernel.</param>
        /// <param name="anything">A buffer of 4 bytes a particle to bind in the list's place.</param>
        public static void SetNoList(CommandBuffer cmd, ComputeKernel kernel, FluidBuffer anything)
        {
            kernel.SetInt(cmd, ListLength, 0);
            kernel.SetBuffer(cmd, Neighbours, anything);
            kernel.SetInt(cmd, NeighbourCountsBegin, 0);
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
