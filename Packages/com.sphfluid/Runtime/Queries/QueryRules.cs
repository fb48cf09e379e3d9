using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What can be asked; each throws an <see cref="ArgumentException"/> with the cure.</summary>
    internal static class QueryRules
    {
        public static QueryWord Ray(Vector3 origin, Vector3 direction, float length)
        {
            Require.Finite(origin, nameof(origin));
            float magnitude = direction.magnitude;
            if (!AffineMath.IsFinite(magnitude) || magnitude == 0f)
            {
                throw new ArgumentException($"The direction {direction} of a ray has no finite length above 0. Give another.",
                    nameof(direction));
            }
            length = Mathf.Min(float.MaxValue, length); // NaN stays
            Require.Positive(length, nameof(length));
            return new QueryWord(direction / magnitude, length);
        }

        public static QueryWord Reach(Vector3 world, float distance)
        {
            Require.Finite(world, nameof(world));
            distance = Mathf.Min(1e18f, distance); // NaN stays
            Require.Positive(distance, nameof(distance));
            return new QueryWord(Vector3.zero, distance);
        }

        public static void Check(Vector3 centre, Vector2 size, Quaternion rotation)
        {
            Require.Area(size, nameof(size));
            Require.Place(centre, rotation);
        }

        public static void Check(Vector3 centre, Vector3 size, Quaternion rotation)
        {
            Require.Size(size, nameof(size));
            Require.Place(centre, rotation);
        }
    }
}
