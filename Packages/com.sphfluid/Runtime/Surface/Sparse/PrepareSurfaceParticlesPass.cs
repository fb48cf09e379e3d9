using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The particles of a sparse surface as its field reads them (Shaders/Surface/Sparse/SurfaceParticles.hlsl).
    /// </summary>
    internal sealed class SurfaceParticles : BufferSet
    {
        private FluidBuffer kernels, shapes;

        /// <summary>float4 a particle: centre and weight of its kernel.</summary>
        public FluidBuffer Kernels => kernels;

        /// <summary>KernelShape a particle; null while all kernels are round.</summary>
        public FluidBuffer Shapes => shapes;

        /// <summary>Makes the buffers large enough; what they held may be lost.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public void Reserve(int particles, bool stretched)
        {
            Grow(ref kernels, "SurfaceParticles", particles, 4 * sizeof(float));
            if (stretched) Grow(ref shapes, "SurfaceShapes", particles, 6 * sizeof(float));
        }
    }

    /// <summary>
    /// Each particle's kernel in the surface's field, and the blocks near the surface
    /// (Shaders/Surface/Sparse/PrepareSurfaceParticles.compute). The smooth field sums over neighbours, those that the solver
    /// lists where it does; the thesis's field marks by the density that the solver has.
    /// </summary>
    internal sealed class PrepareSurfaceParticlesPass : ComputePass
    {
        // Blocks within this distance of a flagged particle are active, in spacings: no iso value in use lies farther
        // out.
        private const float MarkReach = 1.25f;

        // Near the surface are particles with fewer neighbours than 24 of the 32.5 that R = 2 dx gives in a lattice,
        // with their mean more than a quarter of a spacing away, or crowded as no liquid is (coincident particles are a
        // drop of their own).
        private const double FewNeighbours = 24.0 / 32.5;
        private const float FarMean = 0.25f;
        private const float HighDensity = 1.5f;

        // The topmost layer of a lattice has 0.81 of the rest density, the one below 1; liquid in motion varies by some
        // per cent.
        private const float LowDensity = 0.9f;

        // How deep the surface reaches into a wall of triangles, in spacings: deeper than it would lie before the wall, less than what
        // is thin there.
        private const float WallPull = 0.3f;

        private const string SprayKeyword = "SURFACE_SPRAY";

        private static readonly int FieldWeight = Id("_FieldWeight");
        private static readonly int Smoothing = Id("_Smoothing");
        private static readonly int LongestShift = Id("_LongestShift");
        private static readonly int WallsClosed = Id("_WallsClosed");
        private static readonly int MarkReachId = Id("_MarkReach");
        private static readonly int FewNeighboursId = Id("_FewNeighbours");
        private static readonly int FarMeanId = Id("_FarMean");
        private static readonly int HighDensityId = Id("_HighDensity");
        private static readonly int WallPullId = Id("_WallPull");
        private static readonly int LowDensityId = Id("_LowDensity");
        private static readonly int DensityScale = Id("_DensityScale");
        private static readonly int DensityOffset = Id("_DensityOffset");

        private readonly ComputeKernel smooth;
        private readonly ComputeKernel thesis;

        public PrepareSurfaceParticlesPass(FluidShaderSet shaders)
            : base(shaders, "PrepareSurfaceParticles")
        {
            smooth = Kernel();
            thesis = Kernel("PrepareThesisParticles");
        }

        public void Record(CommandBuffer cmd, in SurfaceInput input, SurfaceParticles particles, SprayParticles spray)
        {
            ComputeKernel kernel = input.Field.IsThesis ? thesis : smooth;
            using (Sample(cmd))
            {
                input.Solver.BindNeighbours(cmd, kernel);
                input.Solver.BindNearWalls(cmd, kernel);
                input.SetField(cmd, kernel);
                kernel.SetInt(cmd, FluidShaderIds.ParticleCount, input.Solver.ParticleCount);
                kernel.SetFloat(cmd, FieldWeight, (float)KernelAtZero(input));
                kernel.SetBool(cmd, WallsClosed, input.Walls == SurfaceWalls.Closed);
                kernel.SetFloat(cmd, MarkReachId, MarkReach * input.Field.Spacing);
                kernel.SetFloat(cmd, HighDensityId, HighDensity);
                kernel.SetOut(cmd, particles.Kernels);
                kernel.SetKeyword(cmd, SprayKeyword, input.Field.HasSpray);
                if (input.Field.HasSpray) kernel.SetOut(cmd, spray.Spray);
                if (input.Field.IsAnisotropic) kernel.SetOut(cmd, particles.Shapes);
                kernel.Set(cmd, input.Blocks.Table);
                kernel.Set(cmd, input.Blocks.Counters);
                if (input.Field.IsThesis)
                    SetThesis(cmd, input);
                else
                    SetSmooth(cmd, input);
                kernel.DispatchThreads(cmd, input.Solver.ParticleCount);
            }
        }

        private void SetThesis(CommandBuffer cmd, in SurfaceInput input)
        {
            FluidSolverSettings settings = input.Solver.Settings;
            thesis.SetFloat(cmd, LowDensityId, LowDensity);
            thesis.SetFloat(cmd, DensityScale, 1f / settings.RestDensity);
            bool ownMissing = FluidMethods.Get(settings.Method).OmitsOwnDensity(settings);
            thesis.SetFloat(cmd, DensityOffset, ownMissing ? (float)KernelAtZero(input) : 0f);
            thesis.SetBuffer(cmd, FluidShaderIds.Density, input.Solver.Density);
        }

        private void SetSmooth(CommandBuffer cmd, in SurfaceInput input)
        {
            SurfaceFieldSettings field = input.Field;
            input.Solver.BindNeighbourList(cmd, smooth);
            smooth.SetFloat(cmd, WallPullId, WallPull * field.Spacing);
            double ratio = field.SupportRadius / (double)field.Spacing;
            smooth.SetFloat(cmd, Smoothing, field.Smoothing);
            smooth.SetFloat(cmd, LongestShift, field.LongestShift);
            smooth.SetFloat(cmd, FewNeighboursId,
                (float)(FewNeighbours * (4.0 / 3.0 * Math.PI * ratio * ratio * ratio - 1.0)));
            smooth.SetFloat(cmd, FarMeanId, FarMean * field.Spacing);
        }

        // What a particle gives to the field at its own place: W(0) dx³ of poly6, or W(0) m/ρ0.
        private static double KernelAtZero(in SurfaceInput input)
        {
            FluidSolverSettings settings = input.Solver.Settings;
            double radius = input.Field.SupportRadius;
            double volume = input.Field.IsThesis
                ? settings.ParticleMass / (double)settings.RestDensity
                : Math.Pow(input.Field.Spacing, 3.0);
            return volume * 315.0 / (64.0 * Math.PI * radius * radius * radius);
        }
    }
}
