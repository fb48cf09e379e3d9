using System;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The sparse surface.</summary>
    internal sealed class SparseVariant : SurfaceVariant
    {
        private readonly SparseSurface surface;
        private readonly Func<FluidSolverSettings, SurfaceGrid, SurfaceFieldSettings> field;
        private int lateBlocks;

        /// <summary>The surface of a field.</summary>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="cell">Edge of a cell [dx].</param>
        /// <param name="field">Makes the field for a liquid and a grid over its domain.</param>
        public SparseVariant(FluidShaderSet shaders, float cell, Func<FluidSolverSettings, SurfaceGrid, SurfaceFieldSettings> field)
            : base(cell)
        {
            surface = new SparseSurface(shaders);
            this.field = field;
        }

        /// <summary>The smooth field of a quality.</summary>
        public static SparseVariant Smooth(FluidShaderSet shaders, FluidSurfaceQuality quality, float cell) =>
            new SparseVariant(shaders, cell, (settings, _) => SurfaceFieldSettings.For(quality, settings, cell));

        /// <summary>The smooth field as clear water has it: particles with little company leave it, to be drawn as spray.</summary>
        public static SparseVariant Spray(FluidShaderSet shaders) =>
            new SparseVariant(shaders, 0.75f,
                (settings, _) => MeasuredWater.FieldOf(FluidSurfaceQuality.Default, settings, new FluidWaterLook()));

        /// <summary>Yu and Turk's kernels, stretched along the surface.</summary>
        public static SparseVariant Anisotropic(FluidShaderSet shaders, float cell) =>
            new SparseVariant(shaders, cell, (settings, _) => SurfaceFieldSettings.Anisotropic(settings, cell));

        /// <summary>The thesis's field.</summary>
        public static SparseVariant Thesis(FluidShaderSet shaders, float cell) =>
            new SparseVariant(shaders, cell, (settings, grid) => SurfaceFieldSettings.Thesis(settings, grid));

        /// <inheritdoc/>
        public override SurfaceMesh Mesh(SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            FluidSolverSettings settings = solver.Settings;
            SurfaceGrid grid = SurfaceGrid.OverDomain(settings.DomainSize, Cell * settings.Spacing);
            SurfaceMesh mesh = surface.Extract(solver, field(settings, grid), grid, SurfaceWalls.Closed);
            lateBlocks += surface.Status.LateBlocks;
            return mesh;
        }

        /// <inheritdoc/>
        public override int TakeLateBlocks()
        {
            int taken = lateBlocks;
            lateBlocks = 0;
            return taken;
        }

        /// <inheritdoc/>
        public override void Dispose() => surface.Dispose();
    }
}
