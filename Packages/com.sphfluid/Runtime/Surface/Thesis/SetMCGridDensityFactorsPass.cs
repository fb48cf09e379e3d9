using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Thesis 6.4.3: at each vertex of the marching-cubes grid the density of the particles within the support radius, found through the cells of
    /// the vertex's octant in the fluid grid, as a fraction of the rest density.
    /// </summary>
    sealed class SetMCGridDensityFactorsPass
    {
        const string Name = "SetMCGridDensityFactors";
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);

        readonly ComputeKernel kernel;

        public SetMCGridDensityFactorsPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("SurfaceField", Name);
        }

        public void Record(CommandBuffer cmd, SurfaceField field, FluidSolver solver)
        {
            Vector3Int vertices = field.Grid.Vertices;
            cmd.BeginSample(Marker);
            solver.BindNeighbours(cmd, kernel);
            kernel.SetBuffer(cmd, SurfaceShaderIds.MCGrid, field.Values);
            kernel.SetGrid(cmd, field.Grid);
            kernel.SetFloat(cmd, SurfaceShaderIds.MCDensityScale, 1f / solver.Settings.RestDensity);
            kernel.SetBool(cmd, SurfaceShaderIds.MCWallCompletion, field.WallCompletion);
            kernel.DispatchThreads(cmd, vertices.x, vertices.y, vertices.z);
            cmd.EndSample(Marker);
        }
    }
}
