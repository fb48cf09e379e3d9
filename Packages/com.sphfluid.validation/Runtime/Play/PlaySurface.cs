namespace SphFluid.Validation
{
    /// <summary>The surface of a simulation in a play.</summary>
    internal static class PlaySurface
    {
        /// <summary>
        /// The surface in simulation space, made as the scene's component makes it; without one as a Fluid Surface Renderer does by
        /// default. Waits for the GPU.
        /// </summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for it.</exception>
        public static SurfaceMesh Extract(FluidSimulation simulation)
        {
            FluidSolver solver = simulation.Solver;
            FluidShaderSet shaders = simulation.Profile.Shaders;
            switch (Maker(simulation))
            {
                case FluidGeometrySurfaceRenderer thesis when !thesis.UsesFallback:
                    return ThesisSurfaceMesher.Extract(solver, shaders, thesis.GridSize, thesis.IsoValue, thesis.WallCompletion);
                case FluidSurfaceRenderer renderer:
                    return FluidSurfaceMesher.Extract(solver, shaders, renderer.Surface);
                case FluidSurfaceMesh mesh:
                    return FluidSurfaceMesher.Extract(solver, shaders, mesh.Surface);
                default:
                    return FluidSurfaceMesher.Extract(solver, shaders, new FluidSurfaceOptions());
            }
        }

        /// <summary>The sparse surface that is made of a simulation, as it was read back last; all zero where none is.</summary>
        public static SurfaceStatus StatusOf(FluidSimulation simulation)
        {
            switch (Maker(simulation))
            {
                case FluidSurfaceRenderer renderer: return renderer.Status;
                case FluidSurfaceMesh mesh: return mesh.Status;
                default: return default;
            }
        }

        /// <summary>GPU memory of the surfaces that are made of a simulation [bytes].</summary>
        public static long GpuBytesOf(FluidSimulation simulation)
        {
            long bytes = 0;
            foreach (FluidView view in PlayOverrides.ViewsOf(simulation))
            {
                if (view is FluidSurfaceRenderer renderer)
                    bytes += renderer.GpuBytes;
                else if (view is FluidGeometrySurfaceRenderer thesis)
                    bytes += thesis.GpuBytes;
                else if (view is FluidSurfaceMesh mesh)
                    bytes += mesh.GpuBytes;
            }
            return bytes;
        }

        // The component that makes the surface, or would if it were enabled; null where the scene has none.
        private static FluidView Maker(FluidSimulation simulation)
        {
            FluidView disabled = null;
            foreach (FluidView view in PlayOverrides.ViewsOf(simulation))
            {
                if (view is FluidParticleRenderer) continue;
                if (view.isActiveAndEnabled) return view;
                if (disabled == null) disabled = view;
            }
            return disabled;
        }
    }
}
