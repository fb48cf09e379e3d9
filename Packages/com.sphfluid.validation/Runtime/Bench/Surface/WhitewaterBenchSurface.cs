using SphFluid.Laboratory;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>The sparse surface, and as many particles of whitewater as the liquid has: moved on, listed anew and drawn.</summary>
    internal sealed class WhitewaterBenchSurface : IBenchSurface
    {
        private static readonly ProfilerMarker Marker = GpuLaboratory.CreateMarker(FrameBlocks.DrawWhitewater);

        private readonly SparseBenchSurface surface;
        private readonly MeasuredWhitewater whitewater;

        public WhitewaterBenchSurface(FluidShaderSet shaders, in BenchConfig config, FluidSolver solver)
        {
            surface = new SparseBenchSurface(shaders, config, solver.Settings);
            whitewater = new MeasuredWhitewater(shaders, solver.ParticleCount);
        }

        public BenchSurfaceFacts Facts
        {
            get
            {
                BenchSurfaceFacts facts = surface.Facts;
                facts.GpuBytes += whitewater.GpuBytes;
                return facts;
            }
        }

        public bool HasCapacity => surface.HasCapacity && whitewater.IsFilled;

        public void RecordTrial(CommandBuffer cmd, FluidSolver solver)
        {
            surface.RecordTrial(cmd, solver);
            whitewater.Fill(solver);
        }

        public void TakeTrial() => surface.TakeTrial();

        public void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing)
        {
            surface.Record(cmd, solver, drawing);
            whitewater.Record(cmd, solver);
            cmd.BeginSample(Marker);
            whitewater.Draw(cmd, solver);
            cmd.EndSample(Marker);
        }

        public void Dispose()
        {
            surface.Dispose();
            whitewater.Dispose();
        }
    }
}
