using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Hands a grid to shaders that include Shaders/Surface/SurfaceGrid.hlsl.</summary>
    internal static class SurfaceGridBinding
    {
        // Thin enough to be seen as the wall, thick enough for triangles that floats resolve.
        private const float RingThickness = 0.02f;

        private static readonly int MinimumId = Shader.PropertyToID("_MCMinimum");
        private static readonly int CellSizeId = Shader.PropertyToID("_MCCellSize");
        private static readonly int CellsId = Shader.PropertyToID("_MCCells");
        private static readonly int RingId = Shader.PropertyToID("_MCRing");
        private static readonly int IsoValueId = Shader.PropertyToID("_MCIsoValue");

        /// <summary>Records the grid for the kernel's next dispatch.</summary>
        public static void SetGrid(this ComputeKernel kernel, CommandBuffer cmd, in SurfaceGrid grid,
            SurfaceWalls walls = SurfaceWalls.Closed)
        {
            kernel.SetVector(cmd, MinimumId, grid.Minimum);
            kernel.SetVector(cmd, CellSizeId, grid.CellSize);
            kernel.SetVector(cmd, CellsId, (Vector3)grid.Cells);
            kernel.SetFloat(cmd, RingId, Ring(walls));
        }

        /// <summary>Records the field value that is the surface.</summary>
        public static void SetIsoValue(this ComputeKernel kernel, CommandBuffer cmd, float isoValue) =>
            kernel.SetFloat(cmd, IsoValueId, isoValue);

        /// <summary>Sets grid and iso value for a draw.</summary>
        public static void SetGrid(this MaterialPropertyBlock properties, in SurfaceGrid grid, float isoValue,
            SurfaceWalls walls = SurfaceWalls.Closed)
        {
            properties.SetGrid(grid, walls);
            properties.SetFloat(IsoValueId, isoValue);
        }

        /// <summary>Sets the grid for a draw that reads no field.</summary>
        public static void SetGrid(this MaterialPropertyBlock properties, in SurfaceGrid grid, SurfaceWalls walls)
        {
            properties.SetVector(MinimumId, grid.Minimum);
            properties.SetVector(CellSizeId, grid.CellSize);
            properties.SetVector(CellsId, (Vector3)grid.Cells);
            properties.SetFloat(RingId, Ring(walls));
        }

        private static float Ring(SurfaceWalls walls) => walls == SurfaceWalls.Closed ? RingThickness : 0f;
    }
}
