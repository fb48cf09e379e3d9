using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What the field takes of each particle, and which blocks lie near the surface (Shaders/Surface/Sparse/PrepareSurfaceParticles.compute). The
    /// smooth field sums over neighbours; the thesis's marks by the density that the solver has.
    /// </summary>
    sealed class PrepareSurfaceParticlesPass
    {
        const string Name = "PrepareSurfaceParticles";
        const string ThesisName = "PrepareThesisParticles";

        // Blocks within this distance of a flagged particle are active, in spacings: no iso value in use lies farther out.
        const float MarkReach = 1.25f;

        // Near the surface are particles with fewer neighbours than 24 of the 32.5 that R = 2 dx gives in a lattice, with their mean
        // more than a quarter of a spacing away, or crowded as no liquid is (coincident particles are a drop of their own).
        const double FewNeighbours = 24.0 / 32.5;
        const float FarMean = 0.25f;
        const float HighDensity = 1.5f;

        // The topmost layer of a lattice has 0.81 of the rest density, the one below 1; liquid in motion varies by some per cent.
        const float LowDensity = 0.9f;

        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker(Name);
        static readonly int ParticlesOut = Shader.PropertyToID("_SurfaceParticlesOut");
        static readonly int ShapesOut = Shader.PropertyToID("_SurfaceShapesOut");
        static readonly int FieldWeight = Shader.PropertyToID("_FieldWeight");
        static readonly int Smoothing = Shader.PropertyToID("_Smoothing");
        static readonly int LongestShift = Shader.PropertyToID("_LongestShift");
        static readonly int WallsClosed = Shader.PropertyToID("_WallsClosed");
        static readonly int MarkReachId = Shader.PropertyToID("_MarkReach");
        static readonly int FewNeighboursId = Shader.PropertyToID("_FewNeighbours");
        static readonly int FarMeanId = Shader.PropertyToID("_FarMean");
        static readonly int HighDensityId = Shader.PropertyToID("_HighDensity");
        static readonly int LowDensityId = Shader.PropertyToID("_LowDensity");
        static readonly int DensityScale = Shader.PropertyToID("_DensityScale");
        static readonly int DensityOffset = Shader.PropertyToID("_DensityOffset");

        readonly ComputeKernel smooth;
        readonly ComputeKernel thesis;

        public PrepareSurfaceParticlesPass(FluidShaderSet shaders)
        {
            smooth = shaders.Kernel("PrepareSurfaceParticles", Name);
            thesis = shaders.Kernel("PrepareSurfaceParticles", ThesisName);
        }

        public void Record(CommandBuffer cmd, in BlockFieldInput input)
        {
            ComputeKernel kernel = input.Field.IsThesis ? thesis : smooth;
            FluidSolver solver = input.Solver;
            float dx = input.Field.Spacing;
            cmd.BeginSample(Marker);
            solver.BindNeighbours(cmd, kernel);
            input.SetGlobals(cmd, kernel);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, solver.ParticleCount);
            kernel.SetFloat(cmd, FieldWeight, (float)KernelAtZero(input));
            kernel.SetBool(cmd, WallsClosed, input.WallsClosed);
            kernel.SetFloat(cmd, MarkReachId, MarkReach * dx);
            kernel.SetFloat(cmd, HighDensityId, HighDensity);
            kernel.SetBuffer(cmd, ParticlesOut, input.Particles);
            input.SetShapes(cmd, kernel, ShapesOut);
            kernel.SetBuffer(cmd, SparseShaderIds.BlockTable, input.Blocks.Table);
            kernel.SetBuffer(cmd, SparseShaderIds.SurfaceCounters, input.Blocks.Counters);
            if (input.Field.IsThesis)
            {
                FluidSolverSettings settings = solver.Settings;
                bool ownMissing = FluidMethods.Of(settings.Method).OmitsOwnDensity(settings);
                kernel.SetFloat(cmd, LowDensityId, LowDensity);
                kernel.SetFloat(cmd, DensityScale, 1f / settings.RestDensity);
                kernel.SetFloat(cmd, DensityOffset, ownMissing ? (float)KernelAtZero(input) : 0f);
                kernel.SetBuffer(cmd, FluidShaderIds.Density, solver.Density);
            }
            else
            {
                double ratio = input.Field.SupportRadius / (double)dx;
                kernel.SetFloat(cmd, Smoothing, input.Field.Smoothing);
                kernel.SetFloat(cmd, LongestShift, input.Field.LongestShift);
                kernel.SetFloat(cmd, FewNeighboursId, (float)(FewNeighbours * (4.0 / 3.0 * Math.PI * ratio * ratio * ratio - 1.0)));
                kernel.SetFloat(cmd, FarMeanId, FarMean * dx);
            }

            kernel.DispatchThreads(cmd, solver.ParticleCount);
            cmd.EndSample(Marker);
        }

        // What a particle gives to the field at its own place: W(0) dx³ of poly6, or W(0) m/ρ0.
        static double KernelAtZero(in BlockFieldInput input)
        {
            FluidSolverSettings settings = input.Solver.Settings;
            double radius = input.Field.SupportRadius;
            double volume = input.Field.IsThesis ? settings.ParticleMass / (double)settings.RestDensity : Math.Pow(input.Field.Spacing, 3.0);
            return volume * 315.0 / (64.0 * Math.PI * radius * radius * radius);
        }
    }
}
