using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The moving bodies of a run among what the liquid collides with.</summary>
    internal sealed class CaseBodies
    {
        private readonly IReadOnlyList<CaseBody> bodies;
        private readonly int[] numbers;
        private FluidObstacles obstacles;

        /// <exception cref="ArgumentException">A body has no closed mesh, or no mass and no path.</exception>
        public CaseBodies(IReadOnlyList<CaseBody> bodies)
        {
            this.bodies = bodies;
            numbers = new int[bodies.Count];
            foreach (CaseBody body in bodies)
            {
                if (body.Mesh == null || !body.Mesh.IsClosed)
                {
                    throw new ArgumentException("A body's mesh is missing or not closed: give it all of its faces, each wound outward.",
                        nameof(bodies));
                }
                if (body.Floats && !(body.Mass > 0f))
                {
                    throw new ArgumentException("A body has neither a path nor a mass: give it one of them.", nameof(bodies));
                }
            }
        }

        /// <summary>Number of bodies.</summary>
        public int Count => bodies.Count;

        /// <summary>Adds them to what the liquid collides with.</summary>
        /// <exception cref="ArgumentException">A body floats, and the method moves none.</exception>
        public void AddTo(FluidObstacles obstacles)
        {
            this.obstacles = obstacles;
            for (int i = 0; i < bodies.Count; i++)
            {
                CaseBody body = bodies[i];
                try
                {
                    numbers[i] = body.Floats
                        ? obstacles.AddFloating(body.Mesh, body.Centre, Quaternion.identity, body.Mass, Vector3.zero)
                        : obstacles.Add(body.Mesh, Matrix4x4.Translate(body.Centre));
                }
                catch (NotSupportedException exception)
                {
                    throw new ArgumentException(exception.Message, exception);
                }
            }
        }

        /// <summary>
        /// Lets the next steps, all recorded at once, take what has a path to where that leads; what floats goes its own way.
        /// </summary>
        /// <param name="time">Time at the end of those steps [s].</param>
        public void MoveTo(double time)
        {
            if (bodies.Count == 0) return;
            for (int i = 0; i < bodies.Count; i++)
            {
                if (!bodies[i].Floats) obstacles.MoveTo(numbers[i], Matrix4x4.Translate(bodies[i].At(time)));
            }
            obstacles.Update(Matrix4x4.identity);
        }

        /// <summary>Where the steps left them; waits for the GPU.</summary>
        /// <param name="time">Time now [s].</param>
        public IReadOnlyList<Vector3> Read(double time)
        {
            var places = new Vector3[bodies.Count];
            for (int i = 0; i < places.Length; i++)
            {
                places[i] = bodies[i].Floats ? obstacles.ReadPoseNow(numbers[i], out _) : bodies[i].At(time);
            }
            return places;
        }
    }
}
