using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Thesis 6.4.3: at each vertex of the marching-cubes grid the density that the particles within the support radius
    /// give there, found through the cells of the vertex's octant in the fluid grid, as a fraction of the rest density
    /// (Shaders/Surface/Thesis/SetMCGridDensityFactors.compute).
    /// </summary>
    internal sealed class SetMCGridDensityFactorsPass : ComputePass
    {
        private static readonly int DensityScale = Id("_MCDensityScale");
        private static readonly int WallCompletion = Id("_MCWallCompletion");

        private readonly ComputeKernel kernel;

        public SetMCGridDensityFactorsPass(FluidShaderSet shaders)
            : base(shaders, "SetMCGridDensityFactors")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, SurfaceField field, FluidSolver solver)
        {
            Vector3Int vertices = field.Grid.Vertices;
            using (Sample(cmd))
            {
                solver.BindNeighbours(cmd, kernel);
                kernel.Set(cmd, field.Buffer);
                kernel.SetGrid(cmd, field.Grid);
                kernel.SetFloat(cmd, DensityScale, 1f / solver.Settings.RestDensity);
                kernel.SetBool(cmd, WallCompletion, field.WallCompletion);
                kernel.DispatchThreads(cmd, vertices.x, vertices.y, vertices.z);
            }
        }
    }
}
