using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The compute twin of the geometry shader: the same triangles, read back as a mesh. Waits for the GPU: for export
    /// and tests, not for drawing each frame. The triangles are counted first, the buffer grown to fit, then they are
    /// written.
    /// </summary>
    public sealed class SurfacePolygoniser : IDisposable
    {
        private readonly CountSurfaceVerticesPass countVertices;
        private readonly EmitSurfaceVerticesPass emitVertices;
        private readonly int vertexLimit;
        private readonly FluidBuffer tables;
        private GraphicsBuffer counter;
        private GraphicsBuffer vertices;

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
            {
                throw new ArgumentNullException(nameof(shaders),
                    "A surface polygoniser needs a shader set: assign one in the fluid profile.");
            }
            countVertices = new CountSurfaceVerticesPass(shaders);
            emitVertices = new EmitSurfaceVerticesPass(shaders);
            this.vertexLimit = vertexLimit;
            tables = MarchingCubesTables.CreateBuffer();
            counter = GpuBuffers.Create("SurfaceVertexCount", 1, sizeof(uint), GraphicsBuffer.Target.Raw);
        }

        /// <summary>Triangle corners that the buffer holds; it grows with the surfaces and never shrinks.</summary>
        public int VertexCapacity => vertices?.count ?? 0;

        /// <summary>Triangle corners that a buffer may hold on this device.</summary>
        public static int DeviceVertexLimit =>
            (int)Math.Min(SystemInfo.maxGraphicsBufferSize / EmittedVertex.Stride, int.MaxValue);

        /// <summary>The surface of a field.</summary>
        /// <param name="field">The field as the GPU holds it after all commands executed so far.</param>
        /// <param name="isoValue">Density factor of the surface, greater than 0; 0.5 by custom.</param>
        /// <returns>A closed mesh in the field's space, empty where the field nowhere reaches the iso value. The same
        /// field gives the same mesh.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The iso value is not a positive number.</exception>
        /// <exception cref="FluidDeviceException">The surface has more triangles than a buffer of this device
        /// holds.</exception>
        public SurfaceMesh Polygonise(SurfaceField field, float isoValue = 0.5f)
        {
            if (field == null) throw new ArgumentNullException(nameof(field));
            if (!(isoValue > 0f) || float.IsInfinity(isoValue))
            {
                throw new ArgumentOutOfRangeException(nameof(isoValue),
                    $"The iso value is a density factor greater than 0, not {isoValue}.");
            }

            uint count = Run(cmd => countVertices.Record(cmd, field, isoValue, tables, counter));
            if (count == 0) return new SurfaceMesh(Array.Empty<Vector3>(), Array.Empty<Vector3>(), Array.Empty<int>());
            Reserve(count, field.Grid.Cells);
            uint emitted = Run(cmd => emitVertices.Record(cmd, field, isoValue, tables, counter, vertices,
                VertexCapacity));
            if (emitted != count)
            {
                throw new InvalidOperationException(
                    $"The surface field changed while it was read: {count} triangle corners were counted, {emitted} written.");
            }

            var read = new EmittedVertex[count];
            vertices.GetData(read, 0, 0, (int)count);
            return Weld(read, (int)count);
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            tables.Dispose();
            GpuBuffers.Dispose(ref counter);
            GpuBuffers.Dispose(ref vertices);
        }

        // Runs a pass and returns what it counted.
        private uint Run(Action<CommandBuffer> record)
        {
            var total = new uint[] { 0 };
            counter.SetData(total);
            using (var cmd = new CommandBuffer { name = "Fluid Surface Mesh" })
            {
                record(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            counter.GetData(total);
            return total[0];
        }

        private void Reserve(uint count, Vector3Int cells)
        {
            if (count > vertexLimit)
            {
                throw new FluidDeviceException(
                    $"The surface has {count / 3} triangles on a grid of {cells.x} x {cells.y} x {cells.z} cells; " +
                    $"a buffer of {SystemInfo.graphicsDeviceName} holds {vertexLimit / 3}. Choose a smaller grid size.");
            }
            if (count <= VertexCapacity) return;
            GpuBuffers.Dispose(ref vertices);
            vertices = GpuBuffers.Create("SurfaceVertices", Math.Min(count + count / 2L, vertexLimit),
                EmittedVertex.Stride);
        }

        // Joins the vertices that lie on the same edge of the grid. The order of the cubes in the input does not
        // matter.
        private static SurfaceMesh Weld(EmittedVertex[] emitted, int count)
        {
            int[] firsts = FirstVertexOfEachCube(emitted, count);
            var numbers = new Dictionary<uint, int>(count / 4 + 1);
            var positions = new List<Vector3>(count / 4 + 1);
            var normals = new List<Vector3>(count / 4 + 1);
            var indices = new int[count];
            int written = 0;
            foreach (int first in firsts)
            {
                uint cube = emitted[first].Cube;
                for (int i = first; i < count && emitted[i].Cube == cube; i++)
                {
                    if (!numbers.TryGetValue(emitted[i].Edge, out int number))
                    {
                        number = positions.Count;
                        numbers.Add(emitted[i].Edge, number);
                        positions.Add(emitted[i].Position);
                        normals.Add(emitted[i].Normal);
                    }
                    indices[written++] = number;
                }
            }
            return new SurfaceMesh(positions.ToArray(), normals.ToArray(), indices);
        }

        // Each cube's vertices stand together in the order of its triangles; only the order of the cubes is left to
        // chance on the GPU.
        private static int[] FirstVertexOfEachCube(EmittedVertex[] emitted, int count)
        {
            var cubes = new List<uint>();
            var firsts = new List<int>();
            for (int i = 0; i < count; i++)
            {
                if (i > 0 && emitted[i].Cube == emitted[i - 1].Cube) continue;
                cubes.Add(emitted[i].Cube);
                firsts.Add(i);
            }
            int[] sorted = firsts.ToArray();
            Array.Sort(cubes.ToArray(), sorted);
            return sorted;
        }
    }
}
