using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A liquid of the Standard method with rectangles on its walls.</summary>
    internal sealed class WallForceRig : IDisposable
    {
        private readonly StandardRig liquid;

        public WallForceRig(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            liquid = new StandardRig(settings, particles);
            Obstacles = new FluidObstacles(liquid.Solver.Settings);
        }

        public FluidSolver Solver => liquid.Solver;

        public FluidObstacles Obstacles { get; }

        public WallForces Forces => liquid.Solver.WallForces;

        /// <summary>A rectangle with a normal, its edges along the axes that follow that of the normal.</summary>
        public WallPatch Add(Vector3 centre, Vector3 normal, float width, float height) =>
            Forces.Add(centre, Facing(normal), new Vector2(width, height));

        /// <summary>
        /// Rectangles on the six faces of the domain that reach a support radius beyond them: low x, high x, low y and so on.
        /// </summary>
        public WallPatch[] AddFaces()
        {
            Vector3 half = 0.5f * Solver.Settings.DomainSize;
            var faces = new WallPatch[6];
            for (int face = 0; face < 6; face++)
            {
                var normal = new Vector3();
                normal[face / 2] = face % 2 == 0 ? 1f : -1f;
                faces[face] = Add(-Vector3.Scale(normal, half), normal, 4f, 4f);
            }

            return faces;
        }

        public static Quaternion Facing(Vector3 normal) =>
            Quaternion.LookRotation(normal, Mathf.Abs(normal.y) < 0.9f ? Vector3.up : Vector3.forward);

        public void Frame(int steps)
        {
            Obstacles.Update(Matrix4x4.identity);
            Solver.SetObstacles(Obstacles);
            liquid.Steps(steps);
        }

        /// <summary>Frames of ten steps.</summary>
        public void Play(double seconds)
        {
            for (int steps = (int)(seconds / Solver.Settings.TimeStep); steps > 0; steps -= 10) Frame(10);
            Forces.Complete();
        }

        public FluidParticle[] Particles() => liquid.Particles();

        public float[] Pressures() => liquid.Pressures();

        /// <summary>Σ m v [N s].</summary>
        public Double3 Momentum()
        {
            var sum = new Double3();
            foreach (FluidParticle p in liquid.Particles().Where(p => !p.IsRemoved)) sum += (Double3)p.VelT0;
            return Solver.Settings.ParticleMass * sum;
        }

        /// <summary>Shepard's mean of the particles' pressures at a place [Pa]; 0 where there are none.</summary>
        public double Shepard(FluidParticle[] particles, float[] pressures, Vector3 place)
        {
            double weights = 0.0, sum = 0.0, support = Solver.Settings.SupportRadius;
            for (int i = 0; i < particles.Length; i++)
            {
                double q = ((Double3)particles[i].Position - (Double3)place).Length / support, u = Math.Max(0.0, 1.0 - q);
                double weight = u * u * u * u * (4.0 * q + 1.0);
                weights += weight;
                sum += weight * pressures[i];
            }

            return weights > 0.0 ? sum / weights : 0.0;
        }

        /// <summary>A block on a lattice, its low corner at a place.</summary>
        public static FluidParticle[] Block(Vector3Int counts, float spacing, Vector3 low, Vector3 velocity)
        {
            var particles = new List<FluidParticle>();
            for (int i = 0; i < counts.x * counts.y * counts.z; i++)
            {
                var at = new Vector3(i % counts.x + 0.5f, i / counts.x % counts.y + 0.5f, i / (counts.x * counts.y) + 0.5f);
                particles.Add(new FluidParticle(low + spacing * at, velocity, (uint)i));
            }

            return particles.ToArray();
        }

        public void Dispose()
        {
            Obstacles.Dispose();
            liquid.Dispose();
        }
    }
}
