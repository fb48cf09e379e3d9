using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>The faces of a domain box that are not plain walls: open ones tinted, moving walls with their way in a tenth of a second.</summary>
    internal static class FaceGizmos
    {
        const float Tint = 0.08f;
        const float Seconds = 0.1f;
        static readonly Color OpenColor = new Color(0.4f, 1f, 0.5f, 1f);
        static readonly Color WallColor = new Color(1f, 0.7f, 0.2f, 1f);

        /// <summary>Draws in the box's space, which is set as the gizmos' matrix.</summary>
        public static void Draw(in FluidBoundaries faces, Vector3 size, float alpha)
        {
            Axis(faces, FluidAxes.X, Vector3.right, size, alpha, faces.LowX, faces.HighX);
            Axis(faces, FluidAxes.Y, Vector3.up, size, alpha, faces.LowY, faces.HighY);
            Axis(faces, FluidAxes.Z, Vector3.forward, size, alpha, faces.LowZ, faces.HighZ);
        }

        static void Axis(in FluidBoundaries faces, FluidAxes axis, Vector3 normal, Vector3 size, float alpha, Vector3 low, Vector3 high)
        {
            Vector3 center = Vector3.Scale(normal, size) * 0.5f;
            bool open = (faces.Periodic & axis) != 0;
            if (open)
            {
                Vector3 sheet = size - Vector3.Scale(normal, size);
                Gizmos.color = WithAlpha(OpenColor, Tint * alpha);
                Gizmos.DrawCube(center, sheet);
                Gizmos.DrawCube(-center, sheet);
            }
            else if (faces.NoSlip)
            {
                Gizmos.color = WithAlpha(WallColor, alpha);
                Gizmos.DrawRay(center, high * Seconds);
                Gizmos.DrawRay(-center, low * Seconds);
            }
        }

        static Color WithAlpha(Color color, float alpha) => new Color(color.r, color.g, color.b, alpha);
    }
}
