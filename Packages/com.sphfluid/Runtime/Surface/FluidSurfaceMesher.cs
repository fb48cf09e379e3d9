using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Makes a mesh of a simulation's liquid as it is now. Waits for the GPU; works with any drawing, or none.</summary>
    public static class FluidSurfaceMesher
    {
        /// <summary>The liquid's surface in simulation space.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="shaders">Shader set with the surface's kernels.</param>
        /// <param name="gridSize">Cells a side over the domain.</param>
        /// <param name="isoValue">Density of the surface as a part of the rest density.</param>
        /// <param name="wallCompletion">See <see cref="SurfaceField.WallCompletion"/>.</param>
        /// <returns>A closed mesh [m]; multiply by the simulation's LocalToWorld (<see cref="SurfaceMesh.Transformed"/>) for world space.</returns>
        /// <exception cref="FluidDeviceException">The device lacks something, or room for the surface.</exception>
        public static SurfaceMesh Extract(FluidSolver solver, FluidShaderSet shaders, SurfaceGridSize gridSize, float isoValue = 0.5f, bool wallCompletion = true)
        {
            if (solver == null)
                throw new ArgumentNullException(nameof(solver), "A surface needs a running simulation.");
            using (var field = new SurfaceField(shaders, SurfaceGrid.OverDomain(solver.Settings.DomainSize, gridSize)))
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
