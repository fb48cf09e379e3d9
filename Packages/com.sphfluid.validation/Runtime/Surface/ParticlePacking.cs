using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Random loose packings: particles thrown into a box that push each other apart until they lie about a spacing from each other.
    /// </summary>
    internal static class ParticlePacking
    {
        // Particles nearer than Reach push each other by Strength of what is missing; layers rest at Wall from the sides. In dx.
        private const float Reach = 1.15f, Strength = 0.35f, Wall = 0.45f;
        private const int Rounds = 30;

        /// <summary>A packing of one particle a spacing cubed.</summary>
        /// <param name="size">Edges of the box [dx], from the origin.</param>
        /// <param name="seed">The same seed gives the same packing.</param>
        /// <returns>Positions [dx].</returns>
        public static List<Vector3> Box(Vector3Int size, int seed)
        {
            var random = new System.Random(seed);
            var places = new Vector3[size.x * size.y * size.z];
            for (int i = 0; i < places.Length; i++)
            {
                places[i] =
                    Vector3.Scale(size, new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble()));
            }
            for (int round = 0; round < Rounds; round++) places = Relaxed(places, size);
            return new List<Vector3>(places);
        }

        private static Vector3[] Relaxed(Vector3[] places, Vector3 size)
        {
            var cells = new CellLists(places, Reach);
            var moved = new Vector3[places.Length];
            Vector3 lowest = Wall * Vector3.one, highest = size - lowest;
            for (int i = 0; i < places.Length; i++)
            {
                Vector3 place = places[i], push = Vector3.zero;
                foreach (int other in cells.Around(place))
                {
                    Vector3 apart = place - places[other];
                    float distance = apart.magnitude;
                    if (other != i && distance < Reach && distance > 0f) push += apart * (Strength * (Reach - distance) / distance);
                }
                moved[i] = Vector3.Max(lowest, Vector3.Min(highest, place + push));
            }
            return moved;
        }
    }
}
