using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The surfaces of a scene, by the same steps to the solver as colliders of a simulation, and who gets through them.</summary>
    internal sealed class LeakSurfaces : IDisposable
    {
        private readonly LeakScene scene;
        private readonly FluidObstacles obstacles;
        private readonly List<LeakSurface> surfaces = new List<LeakSurface>();
        private readonly List<LeakDetector> detectors = new List<LeakDetector>();
        private LeakPose[] poses, ends;
        private Vector3[][] shapes; // at the end of the frame; null of surfaces that keep theirs

        public LeakSurfaces(LeakScene scene)
        {
            this.scene = scene;
            obstacles = new FluidObstacles(scene.Settings);
            foreach (LeakBody body in scene.Bodies)
            {
                surfaces.Add(new LeakSurface(body, obstacles));
                detectors.Add(LeakDetector.Of(body, scene.Settings.PeriodLength));
            }
            poses = ends = scene.Bodies.Select(b => b.PoseAt(0)).ToArray();
            shapes = ShapesAt(0);
        }

        /// <summary>Times a surface went too far in a frame to be followed, since the start.</summary>
        public int Jumps => obstacles.Jumps;

        /// <summary>Whether who got through is seen after every step only.</summary>
        public bool NeedsSteps => detectors.Any(d => d.NeedsSteps);

        /// <summary>Where the first surface is.</summary>
        public LeakPose Pose => poses[0];

        /// <summary>Puts all where they start.</summary>
        public void GiveTo(FluidSolver solver)
        {
            Put();
            solver.SetObstacles(obstacles);
        }

        /// <summary>Before the steps of a frame, or of a part of it.</summary>
        /// <param name="frame">Number of the frame, from 1.</param>
        /// <param name="look">Which part, from 1.</param>
        /// <param name="looks">How many parts.</param>
        public void Move(int frame, int look, int looks)
        {
            if (look == 1)
            {
                foreach (LeakSurface surface in surfaces) surface.Push(frame);
            }
            LeakPose[] goals = scene.Bodies.Select(b => b.PoseAt(frame)).ToArray();
            LeakPose[] starts = scene.Bodies.Select(b => b.PoseAt(frame - 1)).ToArray();
            ends = starts.Zip(goals, (a, b) => LeakPose.Between(a, b, look / (float)looks)).ToArray();
            if (look == 1) shapes = ShapesAt(frame);
            if (scene.Solid) Put();
        }

        /// <summary>Looks at the liquid after steps.</summary>
        /// <param name="places">Places of the particles by id [m].</param>
        public void Look(Vector3[] places)
        {
            poses = surfaces.Select((s, i) => s.Where(ends[i])).ToArray();
            for (int i = 0; i < detectors.Count; i++)
            {
                LeakPose pose = poses[i];
                if (shapes[i] != null) detectors[i].Reshape(shapes[i]);
                detectors[i].Look(Array.ConvertAll(places, p => pose.ToSurface(p)));
            }
        }

        /// <summary>Particles that got through any surface.</summary>
        public int CountEscapes() => Enumerable.Range(0, scene.Particles.Length).Count(i => detectors.Any(d => d.HasEscaped(i)));

        /// <inheritdoc/>
        public void Dispose()
        {
            foreach (LeakSurface surface in surfaces) surface.Dispose();
            obstacles.Dispose();
        }

        private Vector3[][] ShapesAt(int frame) => scene.Bodies.Select(b => b.Shape?.Invoke(frame)).ToArray();

        private void Put()
        {
            for (int i = 0; i < surfaces.Count; i++) surfaces[i].MoveTo(ends[i], shapes[i]);
            obstacles.Update(Matrix4x4.identity);
        }
    }
}
