using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A liquid of the Standard method with rigid bodies that it moves.</summary>
    internal sealed class FloatingRig : IDisposable
    {
        private readonly FluidObstacles obstacles;
        private readonly StandardRig liquid;

        public FloatingRig(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            liquid = new StandardRig(settings, particles);
            obstacles = new FluidObstacles(liquid.Solver.Settings);
        }

        public FluidSolver Solver => liquid.Solver;
        public FluidShaderSet Shaders => liquid.Shaders;
        public StandardState State => liquid.State;
        public FluidObstacles Obstacles => obstacles;
        public FloatingBodies Floating => obstacles.Bodies.Floating;

        /// <summary>A box of even density.</summary>
        public FloatingBody AddBox(Vector3 size, float density, Vector3 centre) => AddBox(size, density, centre, Quaternion.identity);

        public FloatingBody AddBox(Vector3 size, float density, Vector3 centre, Quaternion rotation)
        {
            var body = new FloatingBody(FloatingMass.Box(size, density, Solver.Settings.Gravity), new FloatingPose(centre, rotation));
            obstacles.Float(obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(size)), Matrix4x4.TRS(centre, rotation, Vector3.one), 0f), body);
            return body;
        }

        public void Frame(int steps)
        {
            Begin();
            liquid.Steps(steps);
        }

        /// <summary>Gives the solver what the bodies' owners say, as at a frame's start.</summary>
        public void Begin()
        {
            obstacles.Update(Matrix4x4.identity);
            Solver.SetObstacles(obstacles);
        }

        public FloatingState Read(FloatingBody body) => Floating.ReadNow(body);

        public FluidParticle[] Particles() => liquid.Particles();

        public static FluidParticle[] Block(Vector3Int counts, float spacing, Vector3 low, Vector3 velocity = default)
        {
            FluidParticle[] particles = ParticleSets.Lattice(counts, spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++)
            {
                particles[i].Position += low + 0.5f * spacing * (Vector3)counts;
                particles[i].VelT0 = particles[i].VelT1 = velocity;
            }

            return particles;
        }

        public void Dispose()
        {
            liquid.Dispose();
            obstacles.Dispose();
        }
    }
}
