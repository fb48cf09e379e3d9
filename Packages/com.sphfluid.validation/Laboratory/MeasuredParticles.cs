using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: draws particles as a Fluid Particle Renderer does, but into a command buffer.</summary>
    public sealed class MeasuredParticles : IDisposable
    {
        private const int ForwardPass = 0;

        private readonly ParticleSquares squares;

        /// <summary>For measurements: prepares the drawing.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public MeasuredParticles(FluidShaderSet shaders) => squares = new ParticleSquares(shaders);

        /// <summary>For measurements: records the drawing of all particles, simulation space being world space.</summary>
        /// <param name="cmd">Command buffer whose target and view are set.</param>
        /// <param name="solver">The particles.</param>
        /// <param name="size">Edge of a square [m].</param>
        /// <param name="colour">Colour at any speed.</param>
        /// <param name="smoothness">Smoothness of the highlight, 0 to 1.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, float size, Color colour, float smoothness)
        {
            var look = new ParticleLook { Size = size, Color = colour, FastColor = colour, Smoothness = smoothness };
            MaterialPropertyBlock properties =
                squares.Properties(solver.Particles, look, MeasuredSurface.Placement(solver.Settings.DomainSize));
            cmd.DrawProcedural(Matrix4x4.identity, squares.Material, ForwardPass, MeshTopology.Triangles,
                solver.ParticleCount * ParticleSquares.VerticesPerParticle, 1, properties);
        }

        /// <summary>Releases the material.</summary>
        public void Dispose() => squares.Dispose();
    }
}
