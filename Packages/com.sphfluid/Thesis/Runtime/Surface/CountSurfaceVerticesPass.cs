using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How many triangle corners the surface of a dense field has
    /// (Shaders/Surface/Thesis/CountSurfaceVertices.compute).
    /// </summary>
    internal sealed class CountSurfaceVerticesPass : ComputePass
    {
        private static readonly int VertexCount = Id("_SurfaceVertexCount");

        private readonly ComputeKernel kernel;

        public CountSurfaceVerticesPass(FluidShaderSet shaders)
            : base(shaders, "CountSurfaceVertices")
        {
            kernel = Kernel();
        }

        /// <summary>Records the count.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="field">The field.</param>
        /// <param name="isoValue">Its value on the surface.</param>
        /// <param name="tables">See <see cref="MarchingCubesTables.CreateBuffer"/>.</param>
        /// <param name="count">Raw: the corners are added to its first number.</param>
        public void Record(CommandBuffer cmd, SurfaceField field, float isoValue, FluidBuffer tables,
            GraphicsBuffer count)
        {
            using (Sample(cmd))
            {
                SetField(cmd, kernel, field, isoValue, tables);
                kernel.SetBuffer(cmd, VertexCount, count);
                DispatchCubes(cmd, kernel, field.Grid);
            }
        }

        internal static void SetField(CommandBuffer cmd, ComputeKernel kernel, SurfaceField field, float isoValue,
            FluidBuffer tables)
        {
            kernel.Set(cmd, field.Buffer);
            kernel.Set(cmd, tables);
            kernel.SetGrid(cmd, field.Grid);
            kernel.SetIsoValue(cmd, isoValue);
        }

        internal static void DispatchCubes(CommandBuffer cmd, ComputeKernel kernel, in SurfaceGrid grid) =>
            kernel.DispatchThreads(cmd, grid.Cubes.x, grid.Cubes.y, grid.Cubes.z);
    }
}
