using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Thesis 6.4.2: empties the marching-cubes grid before the density factors are summed
    /// (Shaders/Surface/Thesis/ResetMCGrid.compute).
    /// </summary>
    internal sealed class ResetMCGridPass : ComputePass
    {
        private readonly ComputeKernel kernel;

        public ResetMCGridPass(FluidShaderSet shaders)
            : base(shaders, "ResetMCGrid")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, SurfaceField field)
        {
            Vector3Int vertices = field.Grid.Vertices;
            using (Sample(cmd))
            {
                kernel.Set(cmd, field.Buffer);
                kernel.SetGrid(cmd, field.Grid);
                kernel.DispatchThreads(cmd, vertices.x, vertices.y, vertices.z);
            }
        }
    }
}
