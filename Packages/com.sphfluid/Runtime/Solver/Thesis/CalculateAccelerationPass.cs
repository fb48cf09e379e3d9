using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Thesis 6.3.3: the fluid's acceleration, limited, then the collisions' over the scene's triangles, then gravity and the body force.</summary>
    internal sealed class CalculateAccelerationPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("CalculateAcceleration");

        readonly ComputeKernel kernel;

        public CalculateAccelerationPass(FluidShaderSet shaders)
        {
            kernel = shaders.Kernel("CalculateAcceleration", "CalculateAcceleration");
        }

        public void Record(CommandBuffer cmd, FluidState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            cmd.BeginSample(Marker);
            DomainBindings.SetPeriodic(cmd, kernel, settings);
            DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
            DomainBindings.SetWallDrag(cmd, kernel, settings, step);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            kernel.SetFloat(cmd, FluidShaderIds.PrintedMass, settings.ForceTimesMass ? settings.ParticleMass : 0f);
            kernel.SetFloat(cmd, FluidShaderIds.AccelerationLimit,
                settings.AccelerationLimitEnabled ? settings.AccelerationLimitAt(step.Length) : float.MaxValue);
            kernel.SetVector(cmd, FluidShaderIds.Gravity, settings.Gravity);
            kernel.SetFloat(cmd, FluidShaderIds.TimeStep, step.Length);
            kernel.SetFloat(cmd, FluidShaderIds.KickStep, step.Kick);
            kernel.SetVector(cmd, FluidShaderIds.DomainHalfSize, 0.5f * settings.DomainSize);
            kernel.SetFloat(cmd, FluidShaderIds.WallStiffness, settings.WallStiffness);
            kernel.SetFloat(cmd, FluidShaderIds.WallDamping, settings.WallDamping);
            kernel.SetFloat(cmd, FluidShaderIds.WallDistance, settings.WallDistance);
            kernel.SetFloat(cmd, FluidShaderIds.WallReach, settings.Spacing);
            kernel.SetInt(cmd, FluidShaderIds.ColliderCount, state.ColliderCount);
            kernel.SetBuffer(cmd, FluidShaderIds.Triangles, state.Triangles);
            kernel.SetBuffer(cmd, FluidShaderIds.Colliders, state.Colliders);
            kernel.SetBuffer(cmd, FluidShaderIds.Particles, state.Buffers.Particles);
            kernel.SetBuffer(cmd, FluidShaderIds.Density, state.Buffers.Density);
            kernel.SetBuffer(cmd, FluidShaderIds.Force, state.Thesis.Force);
            kernel.SetBuffer(cmd, FluidShaderIds.Acceleration, state.Thesis.Acceleration);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
            kernel.DispatchThreads(cmd, state.ParticleCount);
            cmd.EndSample(Marker);
        }
    }
}
