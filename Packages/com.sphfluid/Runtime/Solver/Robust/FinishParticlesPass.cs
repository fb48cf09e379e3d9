using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The last motion of a step by its constraints, velocities from displacements, and what acts on velocities: viscosity, friction, the
    /// parting of close pairs.
    /// </summary>
    internal sealed class FinishParticlesPass : ComputePass
    {
        private static readonly int Motions = Id("_Motions");
        private static readonly int MotionRate = Id("_MotionRate");
        private static readonly int InverseStep = Id("_InverseStep");
        private static readonly int SlopeFactor = Id("_SlopeFactor");
        private static readonly int ViscosityFactor = Id("_ViscosityFactor");
        private static readonly int PressureFactor = Id("_PressureFactor");
        private static readonly int LeastSeparation = Id("_LeastSeparation");

        private readonly ComputeKernel kernel;

        public FinishParticlesPass(FluidShaderSet shaders)
            : base(shaders, "FinishParticles")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step.</param>
        /// <param name="iterations">Its iterations.</param>
        public void Record(CommandBuffer cmd, RobustState state, in FluidStep step, int iterations)
        {
            FluidSolverSettings settings = state.Settings;
            double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
            double slope = settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / moment;
            float viscosity = (float)(RobustRules.ActingViscosity(settings, step.Length) / settings.RestDensity);
            float sound = (float)Math.Min(settings.SoundSpeed, RobustRules.EffectiveSoundSpeed(settings, step.Length, iterations));
            using (Sample(cmd))
            {
                RobustBindings.SetMotion(cmd, kernel, state, step.Length, iterations == 1);
                CellBindings.SetFriction(cmd, kernel, state, viscosity);
                ClosePairs.Set(cmd, kernel, settings.WithSoundSpeed(sound), slope, step.Length);
                kernel.SetFloat(cmd, InverseStep, 1f / step.Length);
                kernel.SetFloat(cmd, SlopeFactor, (float)slope);
                kernel.SetFloat(cmd, ViscosityFactor, 2f * viscosity / settings.RestDensity);
                kernel.SetFloat(cmd, PressureFactor, settings.RestDensity / (step.Length * step.Length));
                kernel.SetFloat(cmd, LeastSeparation, 1e-3f * settings.SupportRadius);
                kernel.SetBuffer(cmd, Motions, iterations == 1 ? state.Buffers.Velocities : state.Motion.Displacements);
                kernel.SetFloat(cmd, MotionRate, iterations == 1 ? 1f : 1f / step.Length);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.SetBuffer(cmd, CellBindings.CarriedOut, state.Carried);
                CellBindings.SetCounting(cmd, kernel, state, step);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
