using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles for tests, the same for the same seed.</summary>
    public static class ParticleSets
    {
        /// <summary>Particles anywhere in the box of a size centred on the origin, with random velocities.</summary>
        public static FluidParticle[] Random(int count, Vector3 size, float speed, int seed)
        {
            var random = new System.Random(seed);
            var particles = new FluidParticle[count];
            for (int i = 0; i < count; i++)
            {
                particles[i] = new FluidParticle(Vector3.Scale(RandomVector(random), size), 2f * speed * RandomVector(random), (uint)i);
            }

            return particles;
        }

        /// <summary>A simple cubic lattice with a jitter, centred on the origin.</summary>
        public static FluidParticle[] Lattice(Vector3Int counts, float spacing, float jitter, int seed)
        {
            var random = new System.Random(seed);
            var particles = new FluidParticle[counts.x * counts.y * counts.z];
            for (int i = 0; i < particles.Length; i++)
            {
                int x = i % counts.x;
                int y = i / counts.x % counts.y;
                int z = i / (counts.x * counts.y);
                var cell = new Vector3(x - 0.5f * (counts.x - 1), y - 0.5f * (counts.y - 1), z - 0.5f * (counts.z - 1));
                Vector3 position = spacing * cell + 2f * jitter * RandomVector(random);
                particles[i] = new FluidParticle(position, Vector3.zero, (uint)i);
            }

            return particles;
        }

        /// <summary>A rotation by any angle about any axis.</summary>
        public static Quaternion RandomRotation(System.Random random) =>
            Quaternion.AngleAxis(360f * (float)random.NextDouble(), RandomVector(random).normalized);

        /// <summary>Each component in [-0.5, 0.5).</summary>
        public static Vector3 RandomVector(System.Random random)
        {
            float x = (float)(random.NextDouble() - 0.5);
            float y = (float)(random.NextDouble() - 0.5);
            float z = (float)(random.NextDouble() - 0.5);
            return new Vector3(x, y, z);
        }
    }
}
