using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Forces, leapfrog, walls and the count of the state.Cells, in one dispatch (Shaders/Solver/Standard/MoveParticles.compute).</summary>
    internal sealed class MoveParticlesPass
    {
        // No particle comes nearer to a wall by its own speed, over dx; a settled liquid stays farther.
        const float Shell = 0.25f;

        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("MoveParticles");

        readonly ComputeKernel kernel;

        public MoveParticlesPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("MoveParticles", "MoveParticles");
        }

        public void Record(CommandBuffer cmd, FluidState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            float viscosity = settings.Viscosity / settings.RestDensity;
            double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            float friction = settings.Boundaries.Friction;
            bool isHeld = friction > 0f || state.HasBodies && state.Bodies.HoldLiquid;
            cmd.BeginSample(Marker);
            CellRowsBinding.Set(cmd, kernel, state.Cells, state.Standard.CellStart);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
            DomainBindings.SetWallVelocities(cmd, kernel, settings.Boundaries);
            StandardWallBinding.Set(cmd, kernel, settings);
            GatherWallsPass.SetWalls(cmd, kernel, state);
            NeighbourList.Set(cmd, kernel, state.Standard.List);
            kernel.SetFloat(cmd, StandardShaderIds.FaceDistance, MeshContact.Distance(settings));
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetFloat(cmd, StandardShaderIds.SlopeFactor, (float)(settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / moment));
            kernel.SetFloat(cmd, StandardShaderIds.WallPush, (float)(settings.RestDensity / moment));
            kernel.SetFloat(cmd, StandardShaderIds.ViscosityFactor, 2f * viscosity / settings.RestDensity);
            kernel.SetFloat(cmd, StandardShaderIds.WallViscosity, friction * viscosity);
            kernel.SetFloat(cmd, StandardShaderIds.NoSlipViscosity, isHeld ? viscosity : 0f);
            kernel.SetFloat(cmd, StandardShaderIds.ShellDistance, Shell * settings.Spacing);
            kernel.SetVector(cmd, FluidShaderIds.Gravity, settings.Gravity);
            kernel.SetFloat(cmd, FluidShaderIds.TimeStep, step.Length);
            kernel.SetFloat(cmd, FluidShaderIds.KickStep, step.IsFirst ? 0.5f * step.Length : step.Kick);
            kernel.SetBuffer(cmd, StandardShaderIds.Positions, state.Standard.Positions);
            kernel.SetBuffer(cmd, StandardShaderIds.Velocities, state.Standard.Velocities);
            kernel.SetBuffer(cmd, StandardShaderIds.DensityIn, state.Standard.Density);
            kernel.SetBuffer(cmd, StandardShaderIds.NewPositionsOut, state.Standard.NewPositions);
            kernel.SetBuffer(cmd, StandardShaderIds.NewVelocitiesOut, state.Standard.NewVelocities);
            kernel.SetBuffer(cmd, StandardShaderIds.CellCount, state.Standard.CellCount);
            kernel.SetBuffer(cmd, StandardShaderIds.RankOut, state.Standard.Rank);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
