using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Moves the particles by what an iteration changed of the multipliers, the first of a step by what acts on velocities too, and keeps
    /// them off walls.
    /// </summary>
    internal sealed class MoveByConstraintsPass : ComputePass
    {
        private static readonly int DragStep = Id("_DragStep");
        private static readonly int SlopeFactor = Id("_SlopeFactor");
        private static readonly int ViscosityFactor = Id("_ViscosityFactor");
        private static readonly int LeastSeparation = Id("_LeastSeparation");
        private static readonly int Spacing = Id("_Spacing");

        private readonly ComputeKernel kernel;

        public MoveByConstraintsPass(FluidShaderSet shaders)
            : base(shaders, "MoveByConstraints")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="iterations">Its iterations.</param>
        /// <param name="isFirst">Whether it is the first iteration of the step.</param>
        public void Record(CommandBuffer cmd, RobustState state, float timeStep, int iterations, bool isFirst)
        {
            FluidSolverSettings settings = state.Settings;
            double slope = RobustBindings.Slope(settings),
                viscosity = RobustRules.ActingViscosity(settings, timeStep, iterations) / settings.RestDensity;
            float sound = (float)Math.Min(settings.SoundSpeed, RobustRules.EffectiveSoundSpeed(settings, timeStep, iterations));
            using (Sample(cmd))
            {
                RobustBindings.SetMotion(cmd, kernel, state, timeStep);
                CellBindings.SetFriction(cmd, kernel, state, (float)viscosity);
                ClosePairs.Set(cmd, kernel, settings.WithSoundSpeed(sound), slope, timeStep);
                kernel.SetFloat(cmd, DragStep, isFirst ? timeStep * timeStep : 0f);
                kernel.SetFloat(cmd, SlopeFactor, (float)slope);
                kernel.SetFloat(cmd, ViscosityFactor, (float)(2.0 * viscosity / settings.RestDensity));
                kernel.SetFloat(cmd, LeastSeparation, 1e-3f * settings.SupportRadius);
                kernel.SetFloat(cmd, Spacing, settings.Spacing);
                kernel.Set(cmd, state.Buffers.Velocities);
                kernel.SetOut(cmd, state.Motion.Displacements);
                kernel.SetOut(cmd, state.Buffers.NewPositions);
                kernel.Set(cmd, state.Published.Counters);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
