using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Density by summation with the walls' share, and the pressure term (Shaders/Solver/Standard/StandardDensity.compute).</summary>
    internal sealed class StandardDensityPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("StandardDensity");

        readonly ComputeKernel kernel;

        public StandardDensityPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("StandardDensity", "StandardDensity");
        }

        public void Record(CommandBuffer cmd, FluidState state)
        {
            FluidSolverSettings settings = state.Settings;
            cmd.BeginSample(Marker);
            CellRowsBinding.Set(cmd, kernel, state.Cells, state.Standard.CellStart);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            StandardWallBinding.Set(cmd, kernel, settings);
            GatherWallsPass.SetWalls(cmd, kernel, state);
            NeighbourList.SetOut(cmd, kernel, state.Standard.List);
            kernel.SetFloat(cmd, StandardShaderIds.DensityFactor, (float)(settings.ParticleMass * WendlandKernel.Factor(settings.SupportRadius)));
            kernel.SetFloat(cmd, StandardShaderIds.InverseMoment, (float)(1.0 / WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing)));
            kernel.SetFloat(cmd, StandardShaderIds.SoundSpeedSquared, settings.SoundSpeed * settings.SoundSpeed);
            kernel.SetFloat(cmd, StandardShaderIds.SuctionFloor, settings.PressureClamp ? 0f : -settings.RestDensity);
            kernel.SetBuffer(cmd, StandardShaderIds.Positions, state.Standard.Positions);
            kernel.SetBuffer(cmd, StandardShaderIds.DensityOut, state.Standard.Density);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
