using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Thesis 6.3.3: the fluid's acceleration, limited, then the collisions' over the scene's triangles, then gravity and the body force.
    /// </summary>
    internal sealed class CalculateAccelerationPass : ComputePass
    {
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int PrintedMass = Id("_PrintedMass");
        private static readonly int AccelerationLimit = Id("_AccelerationLimit");
        private static readonly int Gravity = Id("_Gravity");
        private static readonly int TimeStep = Id("_TimeStep");
        private static readonly int KickStep = Id("_KickStep");
        private static readonly int DomainHalfSize = Id("_DomainHalfSize");
        private static readonly int WallStiffness = Id("_WallStiffness");
        private static readonly int WallDamping = Id("_WallDamping");
        private static readonly int WallDistance = Id("_WallDistance");
        private static readonly int WallReach = Id("_WallReach");
        private static readonly int ColliderCount = Id("_ColliderCount");
        private static readonly int Triangles = Id("_Triangles");
        private static readonly int Colliders = Id("_Colliders");

        private readonly ComputeKernel kernel;

        public CalculateAccelerationPass(FluidShaderSet shaders)
            : base(shaders, "CalculateAcceleration")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, ThesisState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            ThesisSettings own = state.Own;
            using (Sample(cmd))
            {
                DomainBindings.SetPeriodic(cmd, kernel, settings);
                DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
                DomainBindings.SetWallDrag(cmd, kernel, settings, step);
                kernel.SetInt(cmd, ParticleCount, state.ParticleCount);
                kernel.SetFloat(cmd, PrintedMass, own.ForceTimesMass ? settings.ParticleMass : 0f);
                kernel.SetFloat(cmd, AccelerationLimit,
                    own.AccelerationLimitEnabled ? own.AccelerationLimitAt(settings.TimeStep, step.Length) : float.MaxValue);
                kernel.SetVector(cmd, Gravity, settings.Gravity);
                kernel.SetFloat(cmd, TimeStep, step.Length);
                kernel.SetFloat(cmd, KickStep, step.Kick);
                kernel.SetVector(cmd, DomainHalfSize, 0.5f * settings.DomainSize);
                kernel.SetFloat(cmd, WallStiffness, own.WallStiffness);
                kernel.SetFloat(cmd, WallDamping, own.WallDamping);
                kernel.SetFloat(cmd, WallDistance, own.WallDistance);
                kernel.SetFloat(cmd, WallReach, settings.Spacing);
                kernel.SetInt(cmd, ColliderCount, state.ColliderCount);
                kernel.SetBuffer(cmd, Triangles, state.Triangles);
                kernel.SetBuffer(cmd, Colliders, state.Colliders);
                kernel.Set(cmd, state.Published.Particles);
                kernel.Set(cmd, state.Published.Density);
                kernel.Set(cmd, state.Buffers.Force);
                kernel.Set(cmd, state.Buffers.Acceleration);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
