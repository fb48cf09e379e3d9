using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// The faces of a domain box that are not plain walls: periodic and open ones tinted, moving walls with their displacement in a tenth
    /// of a second.
    /// </summary>
    internal static class FaceGizmos
    {
        private const float Tint = 0.08f;
        private const float Seconds = 0.1f;
        private static readonly Color PeriodicColor = new Color(0.4f, 1f, 0.5f, 1f);
        private static readonly Color OpenColor = new Color(0.9f, 0.4f, 1f, 1f);
        private static readonly Color WallColor = new Color(1f, 0.7f, 0.2f, 1f);

        /// <summary>Draws in the box's space, which is set as the gizmos' matrix.</summary>
        public static void Draw(in FluidBoundaries faces, Vector3 size, float alpha)
        {
            Face(faces, FluidFaces.LowX, Vector3.left, size, alpha, faces.LowX);
            Face(faces, FluidFaces.HighX, Vector3.right, size, alpha, faces.HighX);
            Face(faces, FluidFaces.LowY, Vector3.down, size, alpha, faces.LowY);
            Face(faces, FluidFaces.HighY, Vector3.up, size, alpha, faces.HighY);
            Face(faces, FluidFaces.LowZ, Vector3.back, size, alpha, faces.LowZ);
            Face(faces, FluidFaces.HighZ, Vector3.forward, size, alpha, faces.HighZ);
        }

        private static void Face(in FluidBoundaries faces, FluidFaces face, Vector3 normal, Vector3 size, float alpha, Vector3 velocity)
        {
            Vector3 outwards = Vector3.Scale(normal, size);
            Vector3 center = 0.5f * outwards;
            bool periodic = (FluidBoundaries.FacesOf(faces.Periodic) & face) != 0, open = (faces.Open & face) != 0;
            if (periodic || open)
            {
                Gizmos.color = WithAlpha(periodic ? PeriodicColor : OpenColor, Tint * alpha);
                Gizmos.DrawCube(center, size - Vector3.Scale(normal, outwards));
            }
            else if (faces.Friction > 0f)
            {
                Gizmos.color = WithAlpha(WallColor, alpha);
                Gizmos.DrawRay(center, velocity * Seconds);
            }
        }

        private static Color WithAlpha(Color color, float alpha) => new Color(color.r, color.g, color.b, alpha);
    }
}
