using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The sparse surface's field with dual marching cubes on the CPU in the place of marching cubes.</summary>
    internal sealed class DualVariant : SurfaceVariant
    {
        private readonly FluidSurfaceQuality quality;
        private readonly SparseFieldReader reader;

        public DualVariant(FluidShaderSet shaders, FluidSurfaceQuality quality, float cell)
            : base(cell)
        {
            this.quality = quality;
            reader = new SparseFieldReader(shaders);
        }

        /// <inheritdoc/>
        public override bool OnGpu => false;

        /// <inheritdoc/>
        public override SurfaceMesh Mesh(SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            FluidSolverSettings liquid = solver.Settings;
            SurfaceFieldSettings settings = SurfaceFieldSettings.For(quality, liquid, Cell);
            SurfaceGrid grid = SurfaceGrid.OverDomain(liquid.DomainSize, settings.CellSize);
            return DualMarchingCubes.Polygonise(grid, reader.Read(solver, settings, grid), settings.IsoValue, true);
        }

        /// <inheritdoc/>
        public override void Dispose() => reader.Dispose();
    }
}
