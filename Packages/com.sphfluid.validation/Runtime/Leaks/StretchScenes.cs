using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Closed surfaces whose scale or shear changes, with liquid inside or round them.</summary>
    internal static class StretchScenes
    {
        private const float Dx = LeakSceneEntry.Spacing;
        private const float Half = 12f * Dx; // of the box that liquid is in
        private const int Frames = 60;

        /// <summary>Frequencies that surfaces swing at [Hz].</summary>
        private static readonly double[] frequencies = { 0.5, 1, 2, 5 };

        /// <summary>Largest speeds of the walls of a box that swings [m/s], one for each frequency.</summary>
        /// <param name="amplitude">Of the scale.</param>
        public static double[] Speeds(double amplitude) => frequencies.Select(f => 2.0 * Math.PI * f * amplitude * Half).ToArray();

        /// <summary>
        /// A box whose scale swings about 1, a pool on its bottom. What it holds is less than it has place for at its smallest.
        /// </summary>
        public static LeakScene Pulse(double amplitude, double speed)
        {
            double frequency = speed / (2.0 * Math.PI * amplitude * Half);
            LeakScene scene = Box(1f + (float)amplitude, (float)(1.0 - amplitude));
            scene.Motion = frame =>
            {
                float scale = (float)(1.0 + amplitude * Math.Sin(2.0 * Math.PI * frequency * frame / LeakScene.FrameRate));
                return new LeakPose(Vector3.zero, Quaternion.identity, scale * Vector3.one);
            };
            return scene;
        }

        /// <summary>The same with one axis that grows as another shrinks.</summary>
        public static LeakScene Uneven(double amplitude, double speed)
        {
            double frequency = speed / (2.0 * Math.PI * amplitude * Half);
            LeakScene scene = Box(1f / (1f - (float)amplitude), 0.8f);
            scene.Motion = frame =>
            {
                float scale = (float)(1.0 + amplitude * Math.Sin(2.0 * Math.PI * frequency * frame / LeakScene.FrameRate));
                return new LeakPose(Vector3.zero, Quaternion.identity, new Vector3(scale, 1f, 1f / scale));
            };
            return scene;
        }

        /// <summary>A box that turns about a slanted axis below a parent of uneven scale.</summary>
        /// <param name="speed">Of its corners [m/s].</param>
        public static LeakScene Spin(double speed)
        {
            var parent = new Vector3(1.5f, 0.8f, 1f);
            double rate = speed / (1.5 * Math.Sqrt(3.0) * Half) * 180.0 / Math.PI; // degrees a second
            LeakScene scene = Box(1.5f * 1.75f, 0.8f);
            scene.Motion = frame =>
                new LeakPose(Vector3.zero, Quaternion.AngleAxis((float)(rate * frame / LeakScene.FrameRate), new Vector3(0.3f, 1f, 0.2f)),
                    Vector3.one, parent);
            return scene;
        }

        /// <summary>A box on its edge below a parent whose scale swings along one axis: its faces shear.</summary>
        public static LeakScene Shear(double speed)
        {
            const double amplitude = 0.4;
            double frequency = speed / (2.0 * Math.PI * amplitude * Half);
            LeakScene scene = Box(1.4f * 1.75f, 0.6f);
            Quaternion tilt = Quaternion.Euler(35f, 0f, 45f);
            scene.Motion = frame =>
            {
                float scale = (float)(1.0 + amplitude * Math.Sin(2.0 * Math.PI * frequency * frame / LeakScene.FrameRate));
                return new LeakPose(Vector3.zero, tilt, Vector3.one, new Vector3(scale, 1f, 1f));
            };
            scene.Particles = Block(0.5f);
            return scene;
        }

        /// <summary>A turning solid that grows eightfold in a pool: its cells are made anew meanwhile.</summary>
        /// <param name="speed">Of its walls [m/s].</param>
        public static LeakScene Grow(double speed)
        {
            const float first = 0.75f * Dx, growth = 8f;
            const float domain = 24f * Dx; // 11 dx from its middle to the floor: more than the solid reaches in the end
            int frames = (int)Math.Ceiling(first * (growth - 1f) / speed * LeakScene.FrameRate);
            var scene = new LeakScene
            {
                Settings = LeakSceneEntry.Water(domain * Vector3.one, 0.5f * domain),
                Surface = Cube(first),
                Stretches = true,
                Frames = frames + 6,
                Motion = frame =>
                {
                    float part = Math.Min(frame / (float)frames, 1f);
                    return new LeakPose(Dx * Vector3.down, Quaternion.AngleAxis(90f * part, new Vector3(1f, 2f, 0.5f)),
                        (1f + (growth - 1f) * part) * new Vector3(1f, 0.6f, 0.8f));
                },
            };
            var obstacle = new WindingNumber(scene.Surface);
            LeakPose start = scene.PoseAt(0);
            scene.Particles =
                CaseLattice.Particles(CaseLattice.Box(new Vector3Int(23, 13, 23), Dx,
                    -0.5f * domain * Vector3.one + 0.5f * Dx * new Vector3(1f, 0f, 1f))
                .Where(p => obstacle.DistanceTo(start.ToSurface(p)) > Dx && !obstacle.Contains(start.ToSurface(p))).ToList());
            return scene;
        }

        private static LeakScene Box(float largest, float smallest)
        {
            return new LeakScene
            {
                Settings = LeakSceneEntry.Water((2f * Half * largest + 4f * Dx) * Vector3.one, 2f * Half),
                Surface = Cube(Half),
                Frames = Frames,
                Stretches = true,
                Particles = Block(smallest),
            };
        }

        // A block in the middle of the box, a sixth of the volume of the box at its smallest.
        private static FluidParticle[] Block(float smallest)
        {
            int count = Mathf.FloorToInt(1.1f * smallest * Half / Dx);
            return CaseLattice.Particles(CaseLattice.Box(new Vector3Int(count, count, count), Dx, -0.5f * count * Dx * Vector3.one)
                .ToList());
        }

        private static Vector3[] Cube(float half) => LeakMeshes.Corners(TriangleMesh.Box(Matrix4x4.Scale(2f * half * Vector3.one)));
    }
}
