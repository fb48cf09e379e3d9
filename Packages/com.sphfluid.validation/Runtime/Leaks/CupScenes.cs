using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Vessels that hold liquid, or let it out at one end only.</summary>
    internal static class CupScenes
    {
        private const float Dx = LeakSceneEntry.Spacing;
        private const float Radius = 6f * Dx, Height = 12f * Dx, Level = 8f * Dx;
        private const int Sides = 12;

        // A cup that stands so has the origin in its middle.
        private static readonly Vector3 Middle = 0.5f * Height * Vector3.down;

        /// <summary>
        /// A cup that goes to and fro at a constant speed, turning round at once every second frame, and rocks with it. The constants are
        /// those of its liquid at rest: the solver does not know of the shaking.
        /// </summary>
        /// <param name="speed">Speed of the cup [m/s].</param>
        /// <param name="lid">Whether it is closed, so that all liquid feels all of the shaking.</param>
        public static LeakScene Shaken(double speed, bool lid)
        {
            const int turn = 2;
            const float rock = 15f; // degrees to either side
            Vector3 stroke = (float)(speed * turn / LeakScene.FrameRate) * new Vector3(0.98f, 0.15f, 0.1f);
            LeakScene scene = Filled(LeakMeshes.Cup(Radius, Height, Sides, lid), 60, stroke);
            Vector3 start = Middle - 0.5f * stroke;
            scene.Motion = frame =>
            {
                int phase = frame % (2 * turn);
                float part = (phase <= turn ? phase : 2 * turn - phase) / (float)turn;
                return new LeakPose(start + part * stroke, Quaternion.AngleAxis(rock * (2f * part - 1f), Vector3.forward));
            };
            Place(scene, scene.PoseAt(0));
            return scene;
        }

        /// <summary>A cup at rest: how the liquid lies in it.</summary>
        public static LeakScene Still()
        {
            LeakScene scene = Filled(LeakMeshes.Cup(Radius, Height, Sides, false), 180, Vector3.zero);
            scene.Rests = true;
            scene.Surface = scene.Surface.Select(p => p + Middle).ToArray();
            Place(scene, new LeakPose(Middle, Quaternion.identity));
            return scene;
        }

        /// <summary>Liquid that runs through a funnel whose folds stand inward and outward by turns.</summary>
        public static LeakScene Funnel()
        {
            const int folds = 14;
            float Star(int k, float radius) => k % 2 == 0 ? radius : 0.72f * radius;
            Vector3 domain = new Vector3(24f, 36f, 24f) * Dx;
            var scene = new LeakScene
            {
                Settings = LeakSceneEntry.Water(domain, 30f * Dx),
                Surface = LeakMeshes.Skirt(k => Star(k, 3.5f * Dx), k => Star(k, 10f * Dx), -6f * Dx, 4f * Dx, folds).ToArray(),
                Frames = 120,
                Rests = true,
            };
            scene.Particles = CaseLattice.Particles(CaseLattice.Box(new Vector3Int(8, 10, 8), Dx, new Vector3(-4f, 4.5f, -4f) * Dx));
            return scene;
        }

        /// <summary>The sample's bunny on its head, filled with liquid.</summary>
        /// <param name="turns">False: it stands on its head. True: it is filled upright and turned over in a second.</param>
        /// <exception cref="FileNotFoundException">The sample is not there.</exception>
        public static LeakScene Bunny(bool turns)
        {
            const int turnFrames = 60;
            Vector3[] bunny = ObjFile.Read(SampleFile("Bunny.obj"));
            Vector3 middle = 0.5f * (bunny.Aggregate(Vector3.Min) + bunny.Aggregate(Vector3.Max));
            Quaternion start = turns ? Quaternion.identity : Quaternion.AngleAxis(180f, Vector3.forward);
            Vector3[] surface = bunny.Select(p => start * (p - middle)).ToArray();
            float side = 0.7f;
            List<Vector3> places = LeakMeshes.Fill(surface, Dx, surface.Max(p => p.y));
            var scene = new LeakScene
            {
                Settings = LeakSceneEntry.Water(side * Vector3.one, 0.42f),
                Surface = surface,
                Frames = turns ? turnFrames + 30 : 60,
                Rests = !turns,
                Particles = CaseLattice.Particles(places),
            };
            if (turns)
            {
                scene.Motion = frame =>
                    new LeakPose(Vector3.zero, Quaternion.AngleAxis(180f * Math.Min(frame, turnFrames) / turnFrames, Vector3.forward));
            }
            return scene;
        }

        // A cup with space round it for a stroke; the liquid is put in by Place.
        private static LeakScene Filled(Vector3[] cup, int frames, Vector3 stroke)
        {
            Vector3 space = new Vector3(2f * Radius, Height, 2f * Radius) + 8f * Dx * Vector3.one;
            return new LeakScene { Settings = LeakSceneEntry.Water(space + stroke, Height), Surface = cup, Frames = frames };
        }

        private static void Place(LeakScene scene, LeakPose pose)
        {
            List<Vector3> places = LeakMeshes.Fill(LeakMeshes.Cup(Radius, Height, Sides, true), Dx, Level);
            scene.Particles = CaseLattice.Particles(places.ConvertAll(pose.ToSimulation));
        }

        private static string SampleFile(string name)
        {
            string file =
                Path.GetFullPath(Path.Combine(Application.dataPath, "..", "Packages", "com.sphfluid", "Samples~", "DamBreak", name));
            return File.Exists(file) ? file
                : throw new FileNotFoundException(
                    $"'{file}' is not there. Put the package into the project's folder Packages, with its samples.");
        }
    }
}
