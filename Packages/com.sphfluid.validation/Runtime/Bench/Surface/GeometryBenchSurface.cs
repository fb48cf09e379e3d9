using SphFluid.Laboratory;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>The thesis's surface: density factors over the whole grid, marching cubes in the geometry shader.</summary>
    internal sealed class GeometryBenchSurface : IBenchSurface
    {
        private readonly SurfaceField field;
        private readonly MeasuredGeometrySurface surface;

        public GeometryBenchSurface(FluidShaderSet shaders, int cells)
        {
            surface = new MeasuredGeometrySurface(shaders);
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
            surface.Record(cmd, field, BenchDrawing.IsoValue, BenchDrawing.Colour, BenchDrawing.Smoothness);
            drawing.EndSurface(cmd);
        }

        public void Dispose()
        {
            field.Dispose();
            surface.Dispose();
        }
    }
}
