using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>A collider that moves, as particles and poses.</summary>
    internal sealed class ExportBody
    {
        public ExportBody(string name, WallParticle[] particles, IReadOnlyList<BodyPose> path)
        {
            Name = name;
            Particles = particles;
            Path = path;
        }

        public string Name { get; }

        /// <summary>Its particles from the pivot, as it is turned at the first pose.</summary>
        public WallParticle[] Particles { get; }

        public IReadOnlyList<BodyPose> Path { get; }
    }
}
