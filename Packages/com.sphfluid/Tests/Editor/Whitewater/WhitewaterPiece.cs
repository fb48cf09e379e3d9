using System.Runtime.InteropServices;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A piece of whitewater as it lies on the GPU: WhitewaterParticle in Shaders/Whitewater/WhitewaterTypes.hlsl.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal struct WhitewaterPiece
    {
        public const uint Spray = 0, Foam = 1, Bubble = 2;

        public Vector3 Position;
        public float Life;
        public Vector3 Velocity;
        public uint Seed;
        public Vector3 Normal;
        public float Age;

        public uint Kind => Seed & 3u;

        /// <summary>Pieces anywhere in a box, some of them dead, the same for the same seed.</summary>
        public static WhitewaterPiece[] Random(int count, Vector3 size, float speed, double dead, int seed)
        {
            var random = new System.Random(seed);
            var pieces = new WhitewaterPiece[count];
            for (int i = 0; i < count; i++)
            {
                pieces[i] = new WhitewaterPiece
                {
                    Position = Vector3.Scale(ParticleSets.RandomVector(random), size),
                    Velocity = 2f * speed * ParticleSets.RandomVector(random),
                    Life = random.NextDouble() < dead ? 0f : 1f + (float)random.NextDouble(),
                    Seed = ((uint)i * 4u) | (uint)random.Next(3),
                    Age = (float)random.NextDouble(),
                };
            }
            return pieces;
        }
    }
}
