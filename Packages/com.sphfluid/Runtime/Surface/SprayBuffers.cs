using UnityEngine;

namespace SphFluid
{
    /// <summary>A surface's spray as the GPU draws it.</summary>
    internal readonly struct SprayBuffers
    {
        /// <summary>Vertices of the square that a drop is drawn on.</summary>
        public const int VerticesPerDrop = 6;

        /// <param name="particles">Shaders/Surface/Sparse/SprayParticle.hlsl.</param>
        /// <param name="arguments">One <see cref="GraphicsBuffer.IndirectDrawArgs"/>.</param>
        /// <param name="dropsPerParticle">Drops that a particle becomes, 1 or more.</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        public SprayBuffers(GraphicsBuffer particles, GraphicsBuffer arguments, int dropsPerParticle, float spacing)
        {
            Particles = particles;
            Arguments = arguments;
            DropsPerParticle = dropsPerParticle;
            Spacing = spacing;
        }

        public GraphicsBuffer Particles { get; }

        public GraphicsBuffer Arguments { get; }

        public int DropsPerParticle { get; }

        public float Spacing { get; }
    }
}
