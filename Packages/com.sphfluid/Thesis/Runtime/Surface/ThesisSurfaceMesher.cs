using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Makes a mesh of a simulation's liquid as the thesis draws it. Waits for the GPU.</summary>
    public static class ThesisSurfaceMesher
    {
        /// <summary>The thesis's surface in simulation space: its field on a dense grid.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="shaders">Shader set with the surface's kernels.</param>
        /// <param name="gridSize">Cells a side over the domain.</param>
        /// <param name="isoValue">Density of the surface as a part of the rest density.</param>
        /// <param name="wallCompletion">See <see cref="SurfaceField.WallCompletion"/>.</param>
        /// <returns>A closed mesh [m].</returns>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold the surface.</exception>
        public static SurfaceMesh Extract(FluidSolver solver, FluidShaderSet shaders, SurfaceGridSize gridSize,
            float isoValue = 0.5f, bool wallCompletion = true)
        {
            FluidSurfaceMesher.RequireSolver(solver);
            Require.Known(gridSize, nameof(gridSize));
            using (var field = new SurfaceField(shaders, gridSize.OverDomain(solver.Settings.DomainSize)))
            using (var polygoniser = new SurfacePolygoniser(shaders))
            using (var cmd = new CommandBuffer { name = "Fluid Surface Mesh" })
            {
                field.WallCompletion = wallCompletion;
                field.Record(cmd, solver);
                Graphics.ExecuteCommandBuffer(cmd);
                return polygoniser.Polygonise(field, isoValue);
            }
        }
    }
}
