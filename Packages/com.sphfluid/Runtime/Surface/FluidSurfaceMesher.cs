using System;

namespace SphFluid
{
    /// <summary>
    /// Makes a mesh of a simulation's liquid as it is now. Waits for the GPU; works with any drawing, or none.
    /// </summary>
    public static class FluidSurfaceMesher
    {
        /// <summary>The liquid's surface in simulation space.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="shaders">Shader set with the surface's kernels.</param>
        /// <param name="quality">Size of the cells, and how smooth the surface is.</param>
        /// <param name="walls">What becomes of the surface at the domain's walls.</param>
        /// <returns>A mesh [m], closed where the walls are; multiply by the simulation's LocalToWorld
        /// (<see cref="SurfaceMesh.Transformed"/>) for world space.</returns>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold the surface.</exception>
        public static SurfaceMesh Extract(FluidSolver solver, FluidShaderSet shaders,
            FluidSurfaceQuality quality = FluidSurfaceQuality.Default, SurfaceWalls walls = SurfaceWalls.Closed)
        {
            Require.Known(quality, nameof(quality));
            Require.Known(walls, nameof(walls));
            return Extract(solver, shaders, new FluidSurfaceOptions { Quality = quality, ClosedAtWalls = walls == SurfaceWalls.Closed });
        }

        /// <summary>The liquid's surface in simulation space, as a component with these options makes it.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="shaders">Shader set with the surface's kernels.</param>
        /// <param name="options">How the surface is made; the triangle budget is for drawing, a mesh is made
        /// whole.</param>
        /// <returns>A mesh [m], closed where the walls are.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The cell size cannot be met.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold the surface.</exception>
        public static SurfaceMesh Extract(FluidSolver solver, FluidShaderSet shaders, FluidSurfaceOptions options)
        {
            RequireSolver(solver);
            if (options == null) throw new ArgumentNullException(nameof(options));
            SurfaceFieldSettings field = options.Field(solver.Settings);
            return Extract(solver, shaders, field, SurfaceGrid.OverDomain(solver.Settings.DomainSize, field.CellSize),
                options.Walls);
        }

        /// <summary>The liquid's surface in simulation space, of a field and on a grid of one's own.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="shaders">Shader set with the surface's kernels.</param>
        /// <param name="field">The field.</param>
        /// <param name="grid">The grid, over the solver's domain.</param>
        /// <param name="walls">What becomes of the surface at the domain's walls.</param>
        /// <returns>A mesh [m], closed where the walls are.</returns>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold the surface.</exception>
        public static SurfaceMesh Extract(FluidSolver solver, FluidShaderSet shaders, in SurfaceFieldSettings field,
            SurfaceGrid grid, SurfaceWalls walls = SurfaceWalls.Closed)
        {
            RequireSolver(solver);
            using (var surface = new SparseSurface(shaders))
                return surface.Extract(solver, field, grid, walls);
        }

        internal static void RequireSolver(FluidSolver solver)
        {
            if (solver == null) throw new ArgumentNullException(nameof(solver), "A surface needs a running simulation.");
        }
    }
}
