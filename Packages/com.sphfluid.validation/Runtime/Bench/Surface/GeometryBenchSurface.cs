using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>The thesis's surface: density factors over the whole grid, marching cubes in the geometry shader.</summary>
    sealed class GeometryBenchSurface : IBenchSurface
    {
        readonly SurfaceField field;
        readonly GeometrySurface surface;

        public GeometryBenchSurface(FluidShaderSet shaders, int cells)
        {
            surface = new GeometrySurface(shaders);
            field = new SurfaceField(shaders, BenchLiquid.SurfaceGrid(cells));
            Facts = BenchSurfaceFacts.Dense(cells, field.GpuBytes);
        }

        public BenchSurfaceFacts Facts { get; }

        public bool HasCapacity => true;

        public void RecordTrial(CommandBuffer cmd, FluidSolver solver)
        {
        }

        public void TakeTrial()
        {
        }

        public void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing)
        {
            field.Record(cmd, solver);
            drawing.BeginSurface(cmd);
            cmd.DrawProcedural(Matrix4x4.identity, surface.Material, BenchDrawing.ForwardPass, MeshTopology.Points, field.Grid.CubeCount, 1,
                surface.Properties(field, BenchDrawing.IsoValue, BenchDrawing.Colour, BenchDrawing.Smoothness, drawing.Placement));
            drawing.EndSurface(cmd);
        }

        public void Dispose()
        {
            field.Dispose();
            surface.Dispose();
        }
    }
}
