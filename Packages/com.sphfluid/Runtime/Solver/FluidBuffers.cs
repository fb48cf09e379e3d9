using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// A running liquid on the GPU, for your own kernels and shaders: its buffers, and what Shaders/FluidBuffers.hlsl reads. Read only:
    /// commands that are submitted after the liquid's steps see it after them. Ask and bind again each frame, because a growing liquid
    /// replaces its buffers; the old ones are kept for a few frames.
    /// </summary>
    public readonly struct FluidBuffers
    {
        private readonly FluidSolver solver;

        /// <summary>
        /// The buffers of a solver; before they are read, record <see cref="FluidSolver.RecordNeighbourSetup"/>.
        /// <see cref="FluidSimulation.TryGetBuffers"/> gives those of a simulation.
        /// </summary>
        /// <param name="solver">The liquid.</param>
        /// <param name="localToWorld">Simulation space to world space, without a scale.</param>
        /// <exception cref="ArgumentNullException">There is no solver.</exception>
        public FluidBuffers(FluidSolver solver, in Matrix4x4 localToWorld)
        {
            Require.Finite(localToWorld, nameof(localToWorld));
            this.solver = solver ?? throw new ArgumentNullException(nameof(solver));
            LocalToWorld = localToWorld;
        }

        /// <summary>Whether the liquid still exists. A stopped or newly started one has released these; ask for others then.</summary>
        public bool IsValid => solver != null && !solver.IsDisposed;

        /// <summary>
        /// Entries of <see cref="Particles"/> to look at, 1 or more: live particles come first, the rest are marked by
        /// <see cref="FluidParticle.Removed"/>.
        /// </summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public int ParticleCount => Solver.ParticleCount;

        /// <summary><see cref="FluidParticle"/> a particle, 48 bytes, sorted by cell; _FluidParticles.</summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public GraphicsBuffer Particles => Solver.Particles;

        /// <summary>Density [kg/m³], float a particle, in the order of <see cref="Particles"/>; _FluidDensities.</summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public GraphicsBuffer Densities => Solver.Density;

        /// <summary>Pressure [Pa], float a particle, in the order of <see cref="Particles"/>; _FluidPressures.</summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public GraphicsBuffer Pressures => Solver.Pressure;

        /// <summary>
        /// First and end of each cell's particles in <see cref="Particles"/>, uint2 a cell of <see cref="Grid"/>; _FluidCells. In a domain
        /// of very many cells it has only those with particles: FluidParticlesOfCell of Shaders/FluidBuffers.hlsl reads both.
        /// </summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public GraphicsBuffer Cells => Solver.GridIndices;

        /// <summary>The cells.</summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public FluidGrid Grid => Solver.Grid;

        /// <summary>The physics: spacing, support radius, mass, rest density and more, SI.</summary>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public FluidSolverSettings Settings => Solver.Settings;

        /// <summary>Simulation space to world space, as of when the buffers were asked for.</summary>
        public Matrix4x4 LocalToWorld { get; }

        private FluidSolver Solver => IsValid ? solver : throw new InvalidOperationException(solver == null
            ? "These are the buffers of no liquid. Take those that TryGetBuffers of a running Fluid Simulation gives."
            : "The liquid of these buffers was stopped or started anew, which released them. Ask TryGetBuffers of the Fluid Simulation " +
                "again, each frame.");

        /// <summary>Records all that Shaders/FluidBuffers.hlsl names for the next dispatches of a kernel.</summary>
        /// <param name="cmd">Command buffer to record into; execute it after the simulation's own, for example in
        /// <see cref="FluidSimulation.Updated"/>.</param>
        /// <param name="shader">The compute shader.</param>
        /// <param name="kernel">Index of the kernel, by ComputeShader.FindKernel.</param>
        /// <exception cref="ArgumentNullException">There is no command buffer or no shader.</exception>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public void Bind(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            if (cmd == null) throw new ArgumentNullException(nameof(cmd));
            if (shader == null) throw new ArgumentNullException(nameof(shader));
            Bind(new FluidBinding(cmd, shader, kernel));
        }

        /// <summary>Sets all that Shaders/FluidBuffers.hlsl names for draws with a property block.</summary>
        /// <param name="properties">The property block.</param>
        /// <exception cref="ArgumentNullException">There is no property block.</exception>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public void Bind(MaterialPropertyBlock properties) =>
            Bind(new FluidBinding(properties ?? throw new ArgumentNullException(nameof(properties))));

        /// <summary>
        /// Sets all that Shaders/FluidBuffers.hlsl names in a material. It holds them until others are set: set them each frame.
        /// </summary>
        /// <param name="material">The material.</param>
        /// <exception cref="ArgumentNullException">There is no material.</exception>
        /// <exception cref="InvalidOperationException">The liquid was stopped, or these are the buffers of none.</exception>
        public void Bind(Material material)
        {
            if (material == null) throw new ArgumentNullException(nameof(material));
            Bind(new FluidBinding(material));
        }

        private void Bind(in FluidBinding to)
        {
            FluidSolver bound = Solver;
            FluidSolverSettings settings = bound.Settings;
            FluidGrid grid = bound.Grid;
            to.Set(FluidBinding.Particles, bound.Particles);
            to.Set(FluidBinding.Cells, bound.GridIndices);
            to.Set(FluidBinding.Densities, bound.Density);
            to.Set(FluidBinding.Pressures, bound.Pressure);
            to.Set(FluidBinding.ParticleCount, bound.ParticleCount);
            to.Set(FluidBinding.Spacing, settings.Spacing);
            to.Set(FluidBinding.SupportRadius, settings.SupportRadius);
            to.Set(FluidBinding.ParticleMass, settings.ParticleMass);
            to.Set(FluidBinding.RestDensity, settings.RestDensity);
            to.Set(FluidBinding.GridOrigin, grid.Origin);
            to.Set(FluidBinding.CellSize, grid.CellSize);
            to.Set(FluidBinding.CellCounts, (Vector3)grid.Counts);
            to.Set(FluidBinding.Period, settings.PeriodLength);
            to.Set(FluidBinding.ToWorld, LocalToWorld);
            to.Set(FluidBinding.FromWorld, LocalToWorld.inverse);
        }
    }
}
