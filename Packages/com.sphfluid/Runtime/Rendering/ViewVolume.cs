using UnityEngine;

namespace SphFluid
{
    /// <summary>What a camera can see, as six planes.</summary>
    internal readonly struct ViewVolume
    {
        private const int Planes = 6;

        private readonly Matrix4x4 matrix;
        private readonly bool isEverything;

        public ViewVolume(Camera camera)
        {
            matrix = camera.cullingMatrix;
            isEverything = camera.stereoEnabled; // two eyes, two volumes
        }

        /// <summary>Whether a box may be in the picture; some that lie beyond a corner of the view are not refused.</summary>
        public bool Touches(Bounds bounds) => Touches(bounds, Vector3.zero);

        /// <summary>Whether a box, or what it reaches when it moves along a direction without end, may be in the picture.</summary>
        /// <param name="bounds">The box, world space.</param>
        /// <param name="direction">Where it moves, e.g. the way of the light that it keeps from others; zero: it stays.</param>
        public bool Touches(Bounds bounds, Vector3 direction)
        {
            for (int i = 0; i < Planes && !isEverything; i++)
            {
                Vector4 plane = Plane(i);
                var inwards = new Vector3(plane.x, plane.y, plane.z);
                var size = new Vector3(Mathf.Abs(plane.x), Mathf.Abs(plane.y), Mathf.Abs(plane.z));
                bool isBeyond = Vector3.Dot(inwards, bounds.center) + plane.w + Vector3.Dot(size, bounds.extents) < 0f;
                if (isBeyond && Vector3.Dot(inwards, direction) <= 0f) return false;
            }
            return true;
        }

        // -w <= x, y, z <= w in the picture, and the planes of that: w + x, w - x, w + y ...
        private Vector4 Plane(int i)
        {
            Vector4 row = matrix.GetRow(i / 2);
            return matrix.GetRow(3) + (i % 2 == 0 ? row : -row);
        }
    }
}
