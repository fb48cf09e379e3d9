using SphFluid.Laboratory;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// A dense surface without a geometry shader: the thesis's field over the whole grid, then one compute pass over all cubes that appends
    /// their triangles to a buffer, whose counter is the first of the draw's arguments. Nothing is read back while it is measured.
    /// </summary>
    internal sealed class DenseBenchSurface : IBenchSurface
    {
        // Corners of triangles, instances, first corner, first instance.
        private static readonly uint[] EmptyArguments = { 0, 1, 0, 0 };

        private readonly int cells;
        private readonly SurfaceField field;
        private readonly DenseSurfaceEmitter emitter;
        private readonly BenchMeshMaterial material;
        private GraphicsBuffer arguments;
        private GraphicsBuffer vertices;
        private long corners;

        public DenseBenchSurface(FluidShaderSet shaders, int cells)
        {
            this.cells = cells;
            field = new SurfaceField(shaders, BenchLiquid.SurfaceGrid(cells));
            emitter = new DenseSurfaceEmitter(shaders);
            material = new BenchMeshMaterial(BenchMeshMaterial.TriangleCornersPass);
            arguments = GpuLaboratory.CreateBuffer("BenchSurfaceArguments", EmptyArguments.Length, sizeof(uint),
                GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw);
            vertices = GpuLaboratory.CreateBuffer("SurfaceVertices", 0, DenseSurfaceEmitter.CornerStride);
        }

        public BenchSurfaceFacts Facts =>
            BenchSurfaceFacts.Dense(cells, field.GpuBytes + emitter.GpuBytes + GpuLaboratory.SizeOf(arguments, vertices), corners);

        public bool HasCapacity { get; private set; }

        public void RecordTrial(CommandBuffer cmd, FluidSolver solver)
        {
            field.Record(cmd, solver);
            RecordMesh(cmd, 0); // counts only
        }

        public void TakeTrial()
        {
            var counted = new uint[EmptyArguments.Length];
            arguments.GetData(counted);
            corners = counted[0];
            if (vertices.count < corners)
            {
                GpuLaboratory.Dispose(ref vertices);
                vertices = GpuLaboratory.CreateBuffer("SurfaceVertices", corners, DenseSurfaceEmitter.CornerStride);
            }
            HasCapacity = true;
        }

        public void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing)
        {
            field.Record(cmd, solver);
            RecordMesh(cmd, vertices.count);
            drawing.BeginSurface(cmd);
            MaterialPropertyBlock properties = material.Properties(field.Grid, vertices);
            cmd.DrawProceduralIndirect(Matrix4x4.identity, material.Material, material.Pass, MeshTopology.Triangles, arguments, 0,
                properties);
            drawing.EndSurface(cmd);
        }

        public void Dispose()
        {
            field.Dispose();
            material.Dispose();
            emitter.Dispose();
            GpuLaboratory.Dispose(ref arguments);
            GpuLaboratory.Dispose(ref vertices);
        }

        private void RecordMesh(CommandBuffer cmd, int capacity)
        {
            cmd.SetBufferData(arguments, EmptyArguments);
            emitter.Record(cmd, field, BenchDrawing.IsoValue, arguments, vertices, capacity);
        }
    }
}
