using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>How liquid that has come to rest lies at a surface.</summary>
    internal readonly struct WallRest
    {
        // In dx. Contact lets particles rest at 0.1; the walls' pressure keeps a layer at about 0.5.
        private const float LayerReach = 1f, PressedReach = 0.15f, SupportReach = 1.5f, HeldWay = 0.1f;

        // Cosines of the angle to straight down within which something carries a particle: others of the liquid, 72 degrees, a wall, 37
        // degrees.
        private const float LiquidCosine = 0.3f, WallCosine = 0.8f;

        private WallRest(double firstLayer, double pressed, double held)
        {
            FirstLayer = firstLayer;
            Pressed = pressed;
            Held = held;
        }

        /// <summary>
        /// Mean distance to the surface of the particles nearer than dx to it, over dx; not a number where there are none.
        /// </summary>
        public double FirstLayer { get; }

        /// <summary>Share of those nearer than 0.15 dx: stacked on the surface.</summary>
        public double Pressed { get; }

        /// <summary>
        /// Share of all particles that gravity does not move although nothing is beneath them: stuck to the surface, or hovering.
        /// </summary>
        public double Held { get; }

        /// <summary>Measures the end of a scene.</summary>
        /// <param name="scene">The scene.</param>
        /// <param name="pose">Where its surface is.</param>
        /// <param name="earlier">Where the particles were a moment before, by id [m].</param>
        /// <param name="end">Where they are now [m].</param>
        public static WallRest Of(LeakScene scene, LeakPose pose, Vector3[] earlier, Vector3[] end)
        {
            float dx = scene.Settings.Spacing;
            Vector3[] places = Array.ConvertAll(end, pose.ToSurface);
            Vector3 down = Quaternion.Inverse(pose.Rotation) * scene.Settings.Gravity.normalized;
            var layer = new List<double>();
            int held = 0;
            for (int i = 0; i < places.Length; i++)
            {
                List<Vector3> toWalls = ToTriangles(scene.Surface, places[i]);
                float nearest = toWalls.Min(w => w.magnitude) / dx;
                if (nearest < LayerReach) layer.Add(nearest);
                bool moved = (end[i] - earlier[i]).magnitude > HeldWay * dx;
                float floor = 0.5f * scene.Settings.DomainSize.y + end[i].y;
                bool carried = floor < SupportReach * dx || toWalls.Any(w => Carries(w, down, WallCosine, dx)) ||
                    places.Any(p => p != places[i] && Carries(p - places[i], down, LiquidCosine, dx));
                held += moved || carried ? 0 : 1;
            }
            double pressed = layer.Count(d => d < PressedReach) / Math.Max(1.0, layer.Count);
            return new WallRest(layer.Count == 0 ? double.NaN : layer.Average(), pressed, held / (double)places.Length);
        }

        private static bool Carries(Vector3 separation, Vector3 down, float cosine, float dx)
        {
            float length = separation.magnitude;
            return length < SupportReach * dx && Vector3.Dot(separation, down) >= cosine * length;
        }

        // The separations to the nearest point of each triangle that has an area: the others are edges of such.
        private static List<Vector3> ToTriangles(Vector3[] corners, Vector3 place)
        {
            var separations = new List<Vector3>();
            for (int t = 0; t < corners.Length; t += 3)
            {
                if (HasArea(corners[t], corners[t + 1], corners[t + 2]))
                {
                    separations.Add(CpuTriangle.Separation(place, corners[t], corners[t + 1], corners[t + 2]));
                }
            }
            return separations;
        }

        // Its height over its longest edge is 1e-5 of that edge or more.
        private static bool HasArea(Vector3 a, Vector3 b, Vector3 c)
        {
            float longest = Mathf.Max((b - a).sqrMagnitude, Mathf.Max((c - a).sqrMagnitude, (c - b).sqrMagnitude));
            return Vector3.Cross(b - a, c - a).magnitude >= 1e-5f * longest && longest > 0f;
        }
    }
}
