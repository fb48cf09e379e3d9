using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: the triangles of a dense field in a buffer that stays on the GPU, without a read-back.</summary>
    public sealed class DenseSurfaceEmitter : IDisposable
    {
        /// <summary>Bytes of a triangle's corner, as Shaders/Surface/Thesis/EmittedVertex.hlsl declares it.</summary>
        public const int CornerStride = EmittedVertex.Stride;

        private readonly EmitSurfaceVerticesPass emit;
        private readonly FluidBuffer tables;

        /// <summary>For measurements: prepares the kernel.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <exception cref="FluidDeviceException">The device cannot run the kernel.</exception>
        public DenseSurfaceEmitter(FluidShaderSet shaders)
        {
            emit = new EmitSurfaceVerticesPass(shaders);
            tables = MarchingCubesTables.CreateBuffer();
        }

        /// <summary>Bytes of GPU memory besides the caller's buffers.</summary>
        public long GpuBytes => GpuBuffers.Size(tables);

        /// <summary>For measurements: records the triangles of all cubes, in no particular order.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="field">The field.</param>
        /// <param name="isoValue">Its value on the surface.</param>
        /// <param name="count">Raw: its first number is where the next corner goes, 0 at first; all corners are added to it.</param>
        /// <param name="corners">Receives the corners, <see cref="CornerStride"/> bytes each.</param>
        /// <param name="capacity">Corners that may be written; cubes that do not fit are counted only.</param>
        public void Record(CommandBuffer cmd, SurfaceField field, float isoValue, GraphicsBuffer count, GraphicsBuffer corners,
            int capacity) =>
                emit.Record(cmd, field, isoValue, tables, count, corners, capacity);

        /// <summary>Releases the tables.</summary>
        public void Dispose() => tables.Dispose();
    }
}
