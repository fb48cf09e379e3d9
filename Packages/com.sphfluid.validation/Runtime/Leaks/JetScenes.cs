using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Liquid that is thrown at edges, corners and walls.</summary>
    internal static class JetScenes
    {
        private const float Dx = LeakSceneEntry.Spacing;
        private static readonly Vector3 domain = new Vector3(24f, 40f, 12f) * Dx;
        private static readonly float half = 0.5f * domain.y;

        /// <summary>A jet down on the edge of an upright sheet; the middle row of particles hits it head-on.</summary>
        public static LeakScene Knife(double speed)
        {
            float z = domain.z;
            Vector3 a = new Vector3(0f, 0f, -z), b = new Vector3(0f, 0f, z), c = new Vector3(0f, -2f * half, z),
                d = new Vector3(0f, -2f * half, -z);
            return Jet(speed, new[] { a, b, c, a, c, d });
        }

        /// <summary>A jet down on the tip of a pyramid; a column of particles hits it head-on.</summary>
        public static LeakScene Vertex(double speed) =>
            Jet(speed, LeakMeshes.Skirt(_ => 5f * Dx, _ => 0f, -10f * Dx, 0f, 4).ToArray());

        /// <summary>A block thrown at an upright sheet in mid-air, which must run down it.</summary>
        public static LeakScene Wall(double speed)
        {
            float z = domain.z;
            Vector3 a = new Vector3(4f * Dx, -2f * half, -z), b = new Vector3(4f * Dx, -2f * half, z),
                c = new Vector3(4f * Dx, 2f * half, z), d = new Vector3(4f * Dx, 2f * half, -z);
            LeakScene scene = Thrown(new[] { a, b, c, a, c, d }, new Vector3Int(6, 10, 8), new Vector3(-4f, 4f, -4f) * Dx,
                (float)speed * Vector3.right);
            scene.Rests = true;
            scene.Frames = 150;
            return scene;
        }

        private static LeakScene Jet(double speed, Vector3[] surface)
        {
            LeakScene scene = Thrown(surface, new Vector3Int(5, 17, 5), new Vector3(-2.5f, 2f, -2.5f) * Dx, (float)speed * Vector3.down);
            scene.Frames = 60;
            return scene;
        }

        private static LeakScene Thrown(Vector3[] surface, Vector3Int counts, Vector3 corner, Vector3 velocity) => new LeakScene
        {
            Settings = LeakSceneEntry.Water(domain, half, velocity.magnitude),
            Surface = surface,
            Particles = CaseLattice.Particles(CaseLattice.Box(counts, Dx, corner), _ => velocity),
        };
    }
}
