using SphFluid.Laboratory;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>The sparse surface as clear water before a floor: thickness, refraction, and spray where the look has it.</summary>
    internal sealed class WaterBenchSurface : IBenchSurface
    {
        private readonly SparseSurface surface;
        private readonly MeasuredWater water;
        private readonly SurfaceGrid grid;
        private readonly SurfaceFieldSettings field;
        private readonly FluidWaterLook look;
        private readonly float spacing;

        public WaterBenchSurface(FluidShaderSet shaders, in BenchConfig config, in FluidSolverSettings settings)
        {
            BenchWaterLook drawn = config.Water.Value;
            surface = new SparseSurface(shaders);
            water = new MeasuredWater(shaders);
            spacing = settings.Spacing;
            look = new FluidWaterLook { Quality = drawn.Quality, Spray = drawn.Drops };
            field = MeasuredWater.FieldOf(config.Quality.Value, settings, look);
            grid = SurfaceGrid.OverDomain(settings.DomainSize, field.CellSize);
        }

        public BenchSurfaceFacts Facts => SparseBenchSurface.FactsOf(surface, grid, water.GpuBytes);

        public bool HasCapacity => surface.Status.IsComplete;

        public void RecordTrial(CommandBuffer cmd, FluidSolver solver) => surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed);

        public void TakeTrial() => surface.ReadStatus();

        public void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing)
        {
            BenchBackdrop backdrop = drawing.Backdrop;
            surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed);
            water.Prepare(surface, grid, spacing, look, backdrop.Colour, backdrop.Depth);
            drawing.RecordThickness(cmd, water);
            if (look.Spray > 0) drawing.RecordSprayBehind(cmd, water);
            drawing.BeginSurface(cmd);
            water.RecordWater(cmd);
            drawing.EndSurface(cmd);
            if (look.Spray > 0) drawing.RecordSpray(cmd, water);
        }

        public void Dispose()
        {
            surface.Dispose();
            water.Dispose();
        }
    }
}
