using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The compute twin of the geometry shader: the same triangles, read back as a mesh. Waits for the GPU: for export and tests, not for drawing
    /// each frame. The triangles are counted first, the buffer grown to fit, then they are written.
    /// </summary>
    public sealed class SurfacePolygoniser : IDisposable
    {
        static readonly ProfilerMarker CountMarker = ComputeKernel.CreateMarker("CountSurfaceVertices");
        static readonly ProfilerMarker EmitMarker = ComputeKernel.CreateMarker("EmitSurfaceVertices");

        readonly ComputeKernel countVertices;
        readonly ComputeKernel emitVertices;
        readonly int vertexLimit;
        GraphicsBuffer tables;
        GraphicsBuffer counter;
        GraphicsBuffer vertices;

        /// <summary>A polygoniser.</summary>
        /// <param name="shaders">Shader set with the surface mesh kernels.</param>
        /// <exception cref="FluidDeviceException">The device cannot run the kernels.</exception>
        public SurfacePolygoniser(FluidShaderSet shaders)
            : this(shaders, DeviceVertexLimit)
        {
        }

        internal SurfacePolygoniser(FluidShaderSet shaders, int vertexLimit)
        {
            if (shaders == null)
                throw new ArgumentNullException(nameof(shaders), "A surface polygoniser needs a shader set: assign one in the fluid profile.");
            countVertices = shaders.Kernel("SurfaceMesh", "CountSurfaceVertices");
            emitVertices = shaders.Kernel("SurfaceMesh", "EmitSurfaceVertices");
            this.vertexLimit = vertexLimit;
            tables = CreateTables();
            counter = GpuBuffers.Create("SurfaceVertexCount", 1, sizeof(uint), GraphicsBuffer.Target.Raw);
        }

        /// <summary>Triangle corners that the buffer holds; it grows as surfaces ask for it and never shrinks.</summary>
        public int VertexCapacity => vertices?.count ?? 0;

        /// <summary>Triangle corners that a buffer may hold on this device.</summary>
        public static int DeviceVertexLimit => (int)Math.Min(SystemInfo.maxGraphicsBufferSize / EmittedVertex.Stride, int.MaxValue);

        /// <summary>The surface of a field.</summary>
        /// <param name="field">The field as the GPU holds it after all commands executed so far.</param>
        /// <param name="isoValue">Density factor of the surface, greater than 0; 0.5 by custom.</param>
        /// <returns>A closed mesh in the field's space, empty where the field nowhere reaches the iso value. The same field gives the same mesh.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The iso value is not a positive number.</exception>
        /// <exception cref="FluidDeviceException">The surface has more triangles than a buffer of this device holds.</exception>
        public SurfaceMesh Polygonise(SurfaceField field, float isoValue = 0.5f)
        {
            if (field == null)
                throw new ArgumentNullException(nameof(field));
            if (!(isoValue > 0f) || float.IsInfinity(isoValue))
                throw new ArgumentOutOfRangeException(nameof(isoValue), $"The iso value is a density factor greater than 0, not {isoValue}.");

            uint count = Run(countVertices, CountMarker, field, isoValue);
            if (count == 0)
                return new SurfaceMesh(Array.Empty<Vector3>(), Array.Empty<Vector3>(), Array.Empty<int>());
            Reserve(count, field.Grid.Cells);
            uint emitted = Run(emitVertices, EmitMarker, field, isoValue);
            if (emitted != count)
                throw new InvalidOperationException($"The surface field changed while it was read: {count} triangle corners were counted, {emitted} written.");

            var read = new EmittedVertex[count];
            vertices.GetData(read, 0, 0, (int)count);
            return SurfaceMesh.Weld(read, (int)count);
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            GpuBuffers.Dispose(ref tables);
            GpuBuffers.Dispose(ref counter);
            GpuBuffers.Dispose(ref vertices);
        }

        internal static GraphicsBuffer CreateTables()
        {
            int[] packed = MarchingCubesTables.Pack();
            GraphicsBuffer buffer = GpuBuffers.Create("MCTables", packed.Length, sizeof(int));
            buffer.SetData(packed);
            return buffer;
        }

        uint Run(ComputeKernel kernel, ProfilerMarker marker, SurfaceField field, float isoValue)
        {
            var total = new uint[] { 0 };
            counter.SetData(total);
            using (var cmd = new CommandBuffer { name = kernel.Name })
            {
                cmd.BeginSample(marker);
                kernel.SetBuffer(cmd, SurfaceShaderIds.MCGrid, field.Values);
                kernel.SetBuffer(cmd, SurfaceShaderIds.MCTables, tables);
                kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertexCount, counter);
                kernel.SetGrid(cmd, field.Grid);
                kernel.SetIsoValue(cmd, isoValue);
                if (kernel == emitVertices)
                {
                    kernel.SetBuffer(cmd, SurfaceShaderIds.SurfaceVertices, vertices);
                    kernel.SetInt(cmd, SurfaceShaderIds.SurfaceVertexCapacity, VertexCapacity);
                }
                Vector3Int cubes = field.Grid.Cubes;
                kernel.DispatchThreads(cmd, cubes.x, cubes.y, cubes.z);
                cmd.EndSample(marker);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            counter.GetData(total);
            return total[0];
        }

        void Reserve(uint count, Vector3Int cells)
        {
            if (count > vertexLimit)
            {
                throw new FluidDeviceException(
                    $"The surface has {count / 3} triangles on a grid of {cells.x} x {cells.y} x {cells.z} cells; a buffer of {SystemInfo.graphicsDeviceName} holds " +
                    $"{vertexLimit / 3}. Choose a smaller grid size.");
            }
            if (count <= VertexCapacity)
                return;
            GpuBuffers.Dispose(ref vertices);
            vertices = GpuBuffers.Create("SurfaceVertices", Math.Min(count + count / 2L, vertexLimit), EmittedVertex.Stride);
        }
    }
}
