using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Closed surfaces in a pool that float, deform, roll or close on the liquid between them.</summary>
    internal static class BodyScenes
    {
        private const float Dx = LeakSceneEntry.Spacing;
        private const float Radius = 8f * Dx; // of balls and wheels
        private const int Frames = 60;

        /// <summary>A box with liquid in it, afloat, that gets a random push of the speed, and a spin, every fifth frame.</summary>
        public static LeakScene Afloat(double speed)
        {
            LeakScene scene = Pool(new Vector3Int(28, 24, 20), 13);
            Float(scene.Bodies[0], scene, Vector3.zero, 0.2f, speed, 1);
            return Filled(scene);
        }

        /// <summary>Two boxes with liquid in them, a light and a heavier one, that are pushed about and into each other.</summary>
        public static LeakScene Bumped(double speed)
        {
            LeakScene scene = Pool(new Vector3Int(34, 24, 20), 13);
            scene.Bodies.Add(new LeakBody());
            Float(scene.Bodies[0], scene, 9f * Dx * Vector3.left, 0.2f, speed, 2);
            Float(scene.Bodies[1], scene, 9f * Dx * Vector3.right, 0.9f, speed, 3);
            return Filled(scene);
        }

        /// <summary>A ball with liquid in it and round it, whose skin waves by a fifth of its radius.</summary>
        /// <param name="speed">Largest of the skin [m/s].</param>
        public static LeakScene Waved(double speed)
        {
            double frequency = speed / (2.0 * Math.PI * 0.2 * Radius);
            LeakScene scene = Pool(new Vector3Int(26, 26, 26), 18);
            scene.Surface = Ball();
            Vector3[] rest = scene.Surface;
            scene.Bodies[0].Shape = frame => Array.ConvertAll(rest, v => Wave(v, 2.0 * Math.PI * frequency * frame / LeakScene.FrameRate));
            return Filled(scene);
        }

        /// <summary>
        /// A box with liquid in it and round it that is wrung to and fro by a turn of 120° between its ends, and shrinks by a tenth.
        /// </summary>
        /// <param name="speed">Largest of its corners [m/s].</param>
        public static LeakScene Wrung(double speed)
        {
            float half = 7f * Dx, angle = Mathf.PI / 3f;
            double frequency = speed / (2.0 * Math.PI * angle * Math.Sqrt(2.0) * half);
            LeakScene scene = Pool(new Vector3Int(26, 26, 26), 18);
            scene.MaySqueeze = true; // at its smallest it has no place for what it holds
            // Faces of many triangles, so that they can wind.
            scene.Surface = Faces(4, half);
            Vector3[] rest = scene.Surface;
            scene.Bodies[0].Shape = frame =>
            {
                float phase = (float)Math.Sin(2.0 * Math.PI * frequency * frame / LeakScene.FrameRate);
                return Array.ConvertAll(rest,
                    v => (1f - 0.1f * Mathf.Abs(phase)) *
                        (Quaternion.AngleAxis(Mathf.Rad2Deg * angle * phase * v.y / half, Vector3.up) * v));
            };
            return Filled(scene);
        }

        /// <summary>A wheel, its axle at the water's surface, that spins.</summary>
        /// <param name="speed">Of its rim [m/s].</param>
        public static LeakScene Wheel(double speed)
        {
            float degrees = (float)(speed / Radius * 180.0 / Math.PI / LeakScene.FrameRate);
            LeakScene scene = Pool(new Vector3Int(16, 28, 28), 14);
            Quaternion axle = Quaternion.FromToRotation(Vector3.up, Vector3.right);
            scene.Surface = LeakMeshes.Cup(Radius, 6f * Dx, 32, true).Select(v => axle * (v + 3f * Dx * Vector3.down)).ToArray();
            scene.Motion = frame => new LeakPose(Vector3.zero, Quaternion.AngleAxis(degrees * frame, Vector3.right));
            return Filled(scene);
        }

        /// <summary>Two slabs that close on a pool until they overlap, and open again.</summary>
        /// <param name="speed">Of each [m/s].</param>
        public static LeakScene Pressed(double speed)
        {
            LeakScene scene = Pool(new Vector3Int(32, 26, 20), 10);
            scene.Bodies.Add(new LeakBody());
            float apart = 8f * Dx, thick = 4f * Dx, stroke = apart + 0.5f * thick + Dx;
            for (int side = 0; side < 2; side++)
            {
                Vector3 along = side == 0 ? Vector3.left : Vector3.right;
                scene.Bodies[side].Surface = LeakMeshes.Corners(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(thick, 18f * Dx, 12f * Dx))));
                scene.Bodies[side].Motion = frame =>
                {
                    double way = speed * frame / LeakScene.FrameRate % (2.0 * stroke);
                    float at = apart + 0.5f * thick - (float)Math.Min(way, 2.0 * stroke - way);
                    return new LeakPose(at * along + 3f * Dx * Vector3.down, Quaternion.Euler(0f, 0f, 4f * along.x));
                };
            }
            scene.MaySqueeze = true;
            return Filled(scene);
        }

        private static void Float(LeakBody body, LeakScene scene, Vector3 place, float ratio, double speed, int seed)
        {
            Vector3 size = new Vector3(11f, 8f, 9f) * Dx;
            body.Surface = LeakMeshes.Corners(TriangleMesh.Box(Matrix4x4.Scale(size)));
            body.Mass = ratio * scene.Settings.RestDensity * size.x * size.y * size.z;
            body.Inertia = body.Mass / 12f * new Vector3(size.y * size.y + size.z * size.z, size.z * size.z + size.x * size.x,
                size.x * size.x + size.y * size.y);
            body.Motion = _ => new LeakPose(place, Quaternion.Euler(10f, 20f * seed, 5f));
            var random = new System.Random(seed);
            Vector3 Any() =>
                new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f,
                    (float)random.NextDouble() - 0.5f).normalized;
            body.Push = frame => frame % 5 == 2 ? ((float)speed * Any(), (float)(speed / size.x) * Any()) : default;
            scene.MaySqueeze = true; // nothing but liquid keeps it from the domain's faces
        }

        private static LeakScene Pool(Vector3Int domain, int layers)
        {
            Vector3 size = (Vector3)domain * Dx;
            return new LeakScene
            {
                Settings = LeakSceneEntry.Water(size, layers * Dx),
                Frames = Frames,
                Particles = CaseLattice.Particles(CaseLattice.Box(new Vector3Int(domain.x, layers, domain.z), Dx, -0.5f * size)),
            };
        }

        // Without what is on a surface at the start.
        private static LeakScene Filled(LeakScene scene)
        {
            var meshes = new List<(TriangleMesh mesh, LeakPose pose)>();
            foreach (LeakBody body in scene.Bodies)
            {
                meshes.Add((TriangleMesh.FromCorners(body.Shape?.Invoke(0) ?? body.Surface), body.PoseAt(0)));
            }
            scene.Particles = CaseLattice.Particles(scene.Particles.Select(p => p.Position)
                .Where(p => meshes.All(m => !m.mesh.IsNear(m.pose.ToSurface(p), 0.45f * Dx))).ToList());
            return scene;
        }

        private static Vector3 Wave(Vector3 v, double phase)
        {
            float around = Mathf.Min(1f, 2f * new Vector2(v.x, v.z).magnitude / Radius);
            return (1f + 0.2f * (float)Math.Sin(phase + 4.0 * Math.Atan2(v.z, v.x) + 5.0 * v.y / Radius) * around) * v;
        }

        // 432 triangles.
        private static Vector3[] Ball() => Faces(6, 1f).Select(v => Radius * v.normalized).ToArray();

        // A cube of a grid of squares on each face, outward.
        private static Vector3[] Faces(int squares, float half)
        {
            float[] lines = Enumerable.Range(0, squares + 1).Select(i => half * (2f * i / squares - 1f)).ToArray();
            Vector3[] top = LeakMeshes.Sheet(lines, lines, half);
            var turns = new[]
            {
                Quaternion.identity, Quaternion.AngleAxis(180f, Vector3.right), Quaternion.AngleAxis(90f, Vector3.right),
                Quaternion.AngleAxis(-90f, Vector3.right),
                Quaternion.AngleAxis(90f, Vector3.forward), Quaternion.AngleAxis(-90f, Vector3.forward),
            };
            // To the lattice of corners, so that faces share them.
            float step = lines[1] - lines[0];
            Vector3 Snapped(Vector3 v) => step * new Vector3(Mathf.Round(v.x / step), Mathf.Round(v.y / step), Mathf.Round(v.z / step));
            return turns.SelectMany(t => top.Select(v => Snapped(t * v))).ToArray();
        }
    }
}
