using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A triangle's corner as EmitSurfaceVertices.compute writes it; mirrors the struct of EmittedVertex.hlsl.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct EmittedVertex
    {
        /// <summary>Bytes of one element.</summary>
        public const int Stride = 32;

        /// <summary>Position [m], simulation space.</summary>
        public Vector3 Position;

        /// <summary>Name of the grid edge it lies on, the same in all cubes around that edge.</summary>
        public uint Edge;

        /// <summary>Unit normal out of the liquid.</summary>
        public Vector3 Normal;

        /// <summary>Number of the cube that emitted it.</summary>
        public uint Cube;
    }

    /// <summary>
    /// The triangles of a dense field's surface, an <see cref="EmittedVertex"/> a corner
    /// (Shaders/Surface/Thesis/EmitSurfaceVertices.compute).
    /// </summary>
    internal sealed class EmitSurfaceVerticesPass : ComputePass
    {
        private static readonly int VertexCount = Id("_SurfaceVertexCount");
        private static readonly int Vertices = Id("_SurfaceVertices");
        private static readonly int Capacity = Id("_SurfaceVertexCapacity");

        private readonly ComputeKernel kernel;

        public EmitSurfaceVerticesPass(FluidShaderSet shaders)
            : base(shaders, "EmitSurfaceVertices")
        {
            kernel = Kernel();
        }

        /// <summary>Records the triangles, cubes in no particular order.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="field">The field.</param>
        /// <param name="isoValue">Its value on the surface.</param>
        /// <param name="tables">See <see cref="MarchingCubesTables.CreateBuffer"/>.</param>
        /// <param name="count">Raw: its first number is where the next corner goes; all corners are added to
        /// it.</param>
        /// <param name="vertices">The corners.</param>
        /// <param name="capacity">Corners that may be written; cubes that do not fit are counted only.</param>
        public void Record(CommandBuffer cmd, SurfaceField field, float isoValue, FluidBuffer tables,
            GraphicsBuffer count, GraphicsBuffer vertices, int capacity)
        {
            using (Sample(cmd))
            {
                CountSurfaceVerticesPass.SetField(cmd, kernel, field, isoValue, tables);
                kernel.SetBuffer(cmd, VertexCount, count);
                kernel.SetBuffer(cmd, Vertices, vertices);
                kernel.SetInt(cmd, Capacity, capacity);
                CountSurfaceVerticesPass.DispatchCubes(cmd, kernel, field.Grid);
            }
        }
    }
}
