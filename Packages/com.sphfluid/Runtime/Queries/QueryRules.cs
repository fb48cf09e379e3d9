using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What can be asked; each throws an <see cref="ArgumentException"/> with the cure.</summary>
    internal static class QueryRules
    {
        public static void Check(Vector3 world, string name)
        {
            if (!AffineMath.IsFinite(world))
                throw new ArgumentException($"The position {world} of a fluid query is not finite. Give a position in metres.", name);
        }

        public static QueryWord Ray(Vector3 origin, Vector3 direction, float length)
        {
            Check(origin, nameof(origin));
            float magnitude = direction.magnitude;
            if (!AffineMath.IsFinite(magnitude) || magnitude == 0f)
                throw new ArgumentException($"The direction {direction} of a ray has no finite length above 0. Give another.", nameof(direction));
            if (!(length > 0f)) throw new ArgumentException($"A ray of {length} m finds nothing. Give it a positive length.", nameof(length));
            return new QueryWord(direction / magnitude, Mathf.Min(length, float.MaxValue));
        }

        public static QueryWord Reach(Vector3 world, float distance)
        {
            Check(world, nameof(world));
            if (!(distance > 0f)) throw new ArgumentException($"Within {distance} m of a place is nothing. Give a positive distance.", nameof(distance));
            return new QueryWord(Vector3.zero, Mathf.Min(distance, 1e18f));
        }

        public static void Check(Vector3 centre, Vector2 size, Quaternion rotation)
        {
            if (!(size.x > 0f && size.y > 0f && AffineMath.IsFinite(size)))
                throw new ArgumentException($"Nothing goes through a rectangle of {size.x} by {size.y} m. Give it two positive edge lengths.", nameof(size));
            Check(centre, rotation);
        }

        public static void Check(Vector3 centre, Vector3 size, Quaternion rotation)
        {
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
                throw new ArgumentException($"A box of {FluidMessage.Lengths(size)} m holds nothing. Give it three positive edge lengths.", nameof(size));
            Check(centre, rotation);
        }

        static void Check(Vector3 centre, Quaternion rotation)
        {
            Check(centre, nameof(centre));
            float norm = rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z + rotation.w * rotation.w;
            if (!(Mathf.Abs(norm - 1f) < 1e-3f))
                throw new ArgumentException($"The rotation {rotation} of a fluid query is none. Give a quaternion of length 1.", nameof(rotation));
        }
    }
}
