using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Globals of the forces and of the motion, for the one pass that has all of them and for those that share them.</summary>
    internal static class MotionBindings
    {
        private static readonly int SlopeFactor = Shader.PropertyToID("_SlopeFactor");
        private static readonly int WallPush = Shader.PropertyToID("_WallPush");
        private static readonly int WallStiffness = Shader.PropertyToID("_WallStiffness");
        private static readonly int ViscosityFactor = Shader.PropertyToID("_ViscosityFactor");
        private static readonly int LeastSeparation = Shader.PropertyToID("_LeastSeparation");
        private static readonly int Gravity = Shader.PropertyToID("_Gravity");

        /// <summary>How far a step's forces take the velocities [s].</summary>
        public static float KickOf(in FluidStep step) => step.IsFirst ? 0.5f * step.Length : step.Kick;

        /// <summary>Rate at which a neighbour at no distance takes over a velocity by viscosity [1/s]: 2 ν m/ρ0 · 210/(π R⁵)/M.</summary>
        public static double PairRate(in FluidSolverSettings settings) =>
            2.0 * settings.Viscosity / ((double)settings.RestDensity * settings.RestDensity) * Slope(settings);

        /// <summary>PairForces.hlsl and what acts on each particle alone: the forces of a step.</summary>
        public static void SetForces(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            double slope = Slope(settings);
            CellBindings.SetSearch(cmd, kernel, state);
            DomainBindings.SetBodyForce(cmd, kernel, settings.BodyForce);
            ForceZones.Set(cmd, kernel, state.Zones, settings.SupportRadius);
            state.List.Set(cmd, kernel);
            kernel.SetFloat(cmd, SlopeFactor, (float)slope);
            ClosePairs.Set(cmd, kernel, settings, slope, KickOf(step));
            kernel.SetFloat(cmd, ViscosityFactor, 2f * (settings.Viscosity / settings.RestDensity) / settings.RestDensity);
            kernel.SetFloat(cmd, LeastSeparation, 1e-3f * settings.SupportRadius);
            kernel.SetVector(cmd, Gravity, settings.Gravity);
            kernel.Set(cmd, state.Buffers.Velocities);
        }

        /// <summary>Walls that push and hold, and the motion: MeshWalls.hlsl, WallFriction.hlsl, WallMotion.hlsl.</summary>
        public static void SetWalls(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
            FluidSolverSettings settings = state.Settings;
            CellBindings.SetWalls(cmd, kernel, state);
            CellBindings.SetFriction(cmd, kernel, state, settings.Viscosity / settings.RestDensity);
            CellBindings.SetShell(cmd, kernel, settings, step.Length);
            kernel.SetFloat(cmd, CellBindings.KickStep, KickOf(step));
            kernel.SetFloat(cmd, WallPush, (float)(settings.RestDensity / Moment(settings)));
            float stiffness = (float)(settings.SoundSpeed / Moment(settings));
            kernel.SetFloat(cmd, WallStiffness, KickOf(step) * step.Length * stiffness * stiffness);
            kernel.Set(cmd, state.Buffers.PositionTerms);
        }

        /// <summary>The end of a step: where its particles go, and their count.</summary>
        public static void SetEnd(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
            kernel.Set(cmd, state.List.Densities);
            kernel.SetOut(cmd, state.Buffers.NewVelocities);
            CellBindings.SetCounting(cmd, kernel, state, step);
            kernel.Set(cmd, state.Published.Counters);
        }

        private static double Moment(in FluidSolverSettings settings) =>
            WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);

        private static double Slope(in FluidSolverSettings settings) =>
            settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / Moment(settings);
    }
}
