using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Forces, leapfrog, walls and the count of the cells, in one dispatch.</summary>
    internal sealed class MoveParticlesPass : ComputePass
    {
        // No particle comes nearer to a wall by its own speed, over dx; a settled liquid stays farther.
        const float Shell = 0.25f;

        static readonly int FaceDistance = Id("_FaceDistance");
        static readonly int SlopeFactor = Id("_SlopeFactor");
        static readonly int WallPush = Id("_WallPush");
        static readonly int ViscosityFactor = Id("_ViscosityFactor");
        static readonly int WallViscosity = Id("_WallViscosity");
        static readonly int NoSlipViscosity = Id("_NoSlipViscosity");
        static readonly int ShellDistance = Id("_ShellDistance");
        static readonly int LeastSeparation = Id("_LeastSeparation");
        static readonly int Gravity = Id("_Gravity");
        static readonly int TimeStep = Id("_TimeStep");
        static readonly int KickStep = Id("_KickStep");

        readonly ComputeKernel kernel;

        public MoveParticlesPass(FluidShaderSet shaders)
            : base(shaders, "MoveParticles")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            float viscosity = settings.Viscosity / settings.RestDensity;
            double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            float friction = settings.Boundaries.Friction;
            double slope = settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / moment;
            float kick = step.IsFirst ? 0.5f * step.Length : step.Kick;
            bool isHeld = friction > 0f || state.HasBodies && state.Bodies.HoldLiquid;
            using (Sample(cmd))
            {
                StandardBindings.SetSearch(cmd, kernel, state);
                StandardBindings.SetWalls(cmd, kernel, state);
                DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
                DomainBindings.SetWallVelocities(cmd, kernel, settings.Boundaries);
                ForceZones.Set(cmd, kernel, state.Zones, settings.SupportRadius);
                if (state.HasFloatingBodies) kernel.Set(cmd, state.Walls.WallBodies);
                state.List.Set(cmd, kernel);
                kernel.SetFloat(cmd, FaceDistance, ContactDistances.Rest(settings));
                kernel.SetFloat(cmd, SlopeFactor, (float)slope);
                ClosePairs.Set(cmd, kernel, settings, slope, kick);
                kernel.SetFloat(cmd, WallPush, (float)(settings.RestDensity / moment));
                kernel.SetFloat(cmd, ViscosityFactor, 2f * viscosity / settings.RestDensity);
                kernel.SetFloat(cmd, WallViscosity, friction * viscosity);
                kernel.SetFloat(cmd, NoSlipViscosity, isHeld ? viscosity : 0f);
                kernel.SetFloat(cmd, ShellDistance, Shell * settings.Spacing);
                kernel.SetFloat(cmd, LeastSeparation, 1e-3f * settings.SupportRadius);
                kernel.SetVector(cmd, Gravity, settings.Gravity);
                kernel.SetFloat(cmd, TimeStep, step.Length);
                kernel.SetFloat(cmd, KickStep, kick);
                kernel.Set(cmd, state.Buffers.Positions);
                kernel.Set(cmd, state.Buffers.Velocities);
                kernel.Set(cmd, state.Buffers.PositionTerms);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                StandardBindings.SetCounting(cmd, kernel, state, step);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
