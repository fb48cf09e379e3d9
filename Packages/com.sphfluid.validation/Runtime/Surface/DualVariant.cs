using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The sparse surface's field with dual marching cubes on the CPU in the place of marching cubes.</summary>
    sealed class DualVariant : SurfaceVariant
    {
        readonly FluidSurfaceQuality quality;
        readonly SurfacePasses passes;
        readonly SurfaceBlocks blocks = new SurfaceBlocks();

        public DualVariant(FluidShaderSet shaders, FluidSurfaceQuality quality, float cell)
            : base(cell)
        {
            this.quality = quality;
            passes = new SurfacePasses(shaders);
        }

        /// <inheritdoc/>
        public override bool OnGpu => false;

        /// <inheritdoc/>
        public override SurfaceMesh Mesh(SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            FluidSolverSettings liquid = solver.Settings;
            SurfaceFieldSettings settings = SurfaceFieldSettings.For(quality, liquid, Cell);
            SurfaceGrid grid = SurfaceGrid.OverDomain(liquid.DomainSize, settings.CellSize);
            Vector3Int counts = SurfaceBlocks.CountsOver(grid.Cells);
            blocks.Reserve(grid.Cells, counts.x * counts.y * counts.z);
            GpuWork.Submit("Surface Variant", cmd => passes.RecordField(cmd, new SurfaceInput(solver, settings, grid, SurfaceWalls.Closed, blocks)));
            return DualMarchingCubes.Polygonise(grid, BlockSamplesReader.Read(blocks, grid), settings.IsoValue, true);
        }

        /// <inheritdoc/>
        public override void Dispose()
        {
            passes.Dispose();
            blocks.Dispose();
        }
    }
}
