using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The correction of the pressure's gradient, and of the density at a surface: Shaders/Solver/Standard/GradientCorrection. Hydrostatic
    /// pressure on an arrangement that a wave shears acts as a stiffness that relaxes, and takes the wave's energy; with the correction it
    /// does not.
    /// </summary>
    internal sealed class GradientCorrectionForce : ParticleForce
    {
        // Over R c: of the density's diffusion; 0.3 is not stable.
        private const double Diffusion = 0.1;

        // Over c/R: rate at which an offset of the density fades.
        private const double Fading = 0.0018;

        // Over ρ0 c/R: rate of the pressure's work from which on the density takes it.
        private const double WorkRate = 0.0015;

        private static readonly int HydrostaticSlope = Shader.PropertyToID("_HydrostaticSlope");
        private static readonly int OffsetFactor = Shader.PropertyToID("_OffsetFactor");
        private static readonly int OffsetStep = Shader.PropertyToID("_OffsetStep");
        private static readonly int WorkThreshold = Shader.PropertyToID("_WorkThreshold");
        private static readonly int OffsetFading = Shader.PropertyToID("_OffsetFading");
        private static readonly int FaceStiffness = Shader.PropertyToID("_FaceStiffness");
        private static readonly int SlopeToGradient = Shader.PropertyToID("_SlopeToGradient");

        /// <summary>None: a liquid without it is the same liquid.</summary>
        public override FluidMethodFeatures Feature => FluidMethodFeatures.None;

        public override string CostVariant => "+correction";

        /// <summary>0: its walks are those of the sort, and what it adds to a step is in the kept costs.</summary>
        public override int Walks => 0;

        public override IReadOnlyList<string> Shaders { get; } = new[] { "GradientMoments", "InvertMoments" };

        public override IEnumerable<string> Shortfalls =>
            ShaderGroup.GradientCorrection.Shortfalls(DeviceCapabilities.Query()).Select(shortfall => shortfall +
            " Leave the profile's Gradient Correction off, or use another device.");

        public override IReadOnlyList<string> ProfileFields { get; } = new[] { "gradientCorrection" };

        public override bool MakesMirrors => true;

        public override bool Carries => true;

        public override void Derive(in FluidRuleInput input, ref StandardSettings settings) =>
            settings.GradientCorrection = input.GradientCorrection;

        public override void Validate(in StandardSettings settings)
        {
        }

        /// <summary>Not with tension, whose constants are calibrated without, and not where viscosity ends waves.</summary>
        public override bool Acts(in StandardSettings settings) =>
            settings.GradientCorrection && !(settings.SurfaceTension > 0f) && !settings.ImplicitViscosity;

        public override string Describe(in FluidRuleInput input) => "the gradient correction";

        public override BufferSet MakeBuffers(int particleCount, bool isPlanned) =>
            new GradientCorrectionBuffers(particleCount, isPlanned);

        public override ForcePasses MakePasses(FluidShaderSet shaders) => new Passes(shaders);

        public override void SetDensity(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
            if (SetKeyword(cmd, kernel, state) is { } buffers) kernel.SetOut(cmd, buffers.Corrections);
        }

        public override void SetMotion(CommandBuffer cmd, ComputeKernel kernel, StandardState state, in FluidStep step)
        {
            if (!(SetKeyword(cmd, kernel, state) is { } buffers)) return;
            FluidSolverSettings settings = state.Settings;
            double radius = settings.SupportRadius, sound = settings.SoundSpeed, crossings = step.Length * sound / radius;
            double factor = SlopeFactor(settings);
            kernel.SetVector(cmd, HydrostaticSlope, (float)(settings.RestDensity / (sound * sound)) * settings.Gravity);
            kernel.SetFloat(cmd, OffsetFactor, (float)(Diffusion * radius * sound * step.Length * factor));
            kernel.SetFloat(cmd, OffsetStep, step.Length);
            kernel.SetFloat(cmd, WorkThreshold, (float)(WorkRate * settings.RestDensity * sound / radius));
            kernel.SetFloat(cmd, OffsetFading, (float)Math.Min(1.0, Fading * crossings));
            double way = factor * step.Length * sound / WendlandKernel.LatticeMoment(radius / settings.Spacing);
            kernel.SetFloat(cmd, FaceStiffness, (float)(way * way));
            kernel.SetFloat(cmd, SlopeToGradient, (float)(radius * factor));
            kernel.Set(cmd, state.List.Densities);
            kernel.SetOut(cmd, buffers.Corrections);
        }

        // Its variants have periodic lengths in any case.
        private static GradientCorrectionBuffers SetKeyword(CommandBuffer cmd, ComputeKernel kernel, StandardState state)
        {
            var buffers = state.ForceBuffers<GradientCorrectionBuffers>();
            if (buffers != null) DomainBindings.SetPeriodicByLengths(cmd, kernel);
            kernel.SetKeyword(cmd, ShaderGroup.GradientCorrection.Keyword, buffers != null);
            return buffers;
        }

        /// <summary>m 210/(π R⁵ ρ0) [1/m²].</summary>
        internal static double SlopeFactor(in FluidSolverSettings settings) =>
            settings.ParticleMass * WendlandKernel.SlopeFactor(settings.SupportRadius) / settings.RestDensity;

        private sealed class Passes : ForcePasses
        {
            private readonly GradientMomentsPass moments;
            private readonly InvertMomentsPass inversion;

            public Passes(FluidShaderSet shaders)
            {
                moments = new GradientMomentsPass(shaders);
                inversion = new InvertMomentsPass(shaders);
            }

            public override void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
            {
                if (state.KeepsOrder) return;
                moments.Record(cmd, state);
                inversion.Record(cmd, state);
            }
        }
    }
}
