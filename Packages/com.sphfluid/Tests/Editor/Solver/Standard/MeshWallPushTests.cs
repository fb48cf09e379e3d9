using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What planes of meshes add to a particle's density, and how they push it, against a reference in double precision.</summary>
    public sealed class MeshWallPushTests
    {
        const float Spacing = 0.05f;
        const float Pressure = 4e-3f; // over the square of the density

        // Planes of any directions, as at a crease: a push that were no gradient would drive the liquid round.
        [Test]
        public void ThePushOfAnyPlanesIsTheGradientOfTheirDensity([Values(1, 2, 3)] int planes, [Values(1, 63, 64, 65, 257)] int count)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Vector3.one, Spacing);
            settings.Gravity = Vector3.zero;
            var random = new System.Random(10 * count + planes);
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.5f * Vector3.one, 0f, 5));
                rig.State.List.Counts.SetData(new uint[count]); // nobody has a neighbour
                WalledStateRig.SetWalls(rig, particles.Select(p => StoredWall.Pack(p.Position, 0.8f, false,
                    Enumerable.Range(0, planes).Select(_ => (ParticleSets.RandomVector(random).normalized, (0.3f + 0.7f * (float)random.NextDouble()) * Spacing)).ToArray())).ToList());
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, Pressure), count).ToArray());
                float step = settings.TimeStep;
                GpuTest.Run(cmd => new MoveParticlesPass(rig.Shaders).Record(cmd, rig.State, new FluidStep(step, step, false)));
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
                StoredWall[] walls = StoredWall.Read(rig.State);
                double push = settings.RestDensity * Pressure / StandardReference.Response(settings) * step, hidden = 0.0;
                for (int i = 0; i < count; i++)
                {
                    var expected = new Double3(-push * walls[i].Gradient(0), -push * walls[i].Gradient(1), -push * walls[i].Gradient(2));
                    Assert.That(((Double3)(Vector3)velocities[i] - expected).Length, Is.LessThan(1e-3 * push / Spacing), $"particle {i}");
                    hidden = Math.Max(hidden, walls[i].Hidden);
                }
                if (planes > 1 && count > 1) Assert.That(hidden, Is.InRange(0.5, 1.0), "some planes hide each other in part");
            }
        }

        // Round the edges and corners of a plate, as the walls are gathered. Without the slope of the fading, liquid gains energy there.
        [Test]
        public void ThePushRoundAFreeEdgeIsTheGradientOfWhatItAdds([Values(1, 63, 64, 65, 257, 1009)] int count)
        {
            const float half = 0.15f;
            FluidSolverSettings settings = StandardStateRig.Water(Vector3.one, Spacing);
            settings.Gravity = Vector3.zero;
            var random = new System.Random(count);
            using (StandardStateRig rig = WalledStateRig.Create(settings, Plate(half), count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(Enumerable.Range(0, count).Select(i => new FluidParticle(Near(half, random), Vector3.zero, (uint)i)).ToArray());
                GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, rig.State, rig.State.Buffers.Positions));
                rig.State.List.Counts.SetData(new uint[count]); // nobody has a neighbour
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, Pressure), count).ToArray());
                float step = settings.TimeStep;
                GpuTest.Run(cmd => new MoveParticlesPass(rig.Shaders).Record(cmd, rig.State, new FluidStep(step, step, false)));
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
                double push = settings.RestDensity * Pressure / StandardReference.Response(settings) * step, beside = 0.0;
                for (int i = 0; i < count; i++)
                {
                    Double3 gradient = Gradient(particles[i].Position, half, settings);
                    Assert.That(((Double3)(Vector3)velocities[i] + push * gradient).Length, Is.LessThan(2e-3 * push / Spacing), $"at {particles[i].Position}");
                    Vector3 away = particles[i].Position - new Vector3(Mathf.Clamp(particles[i].Position.x, -half, half), 0f, Mathf.Clamp(particles[i].Position.z, -half, half));
                    beside = Math.Max(beside, Double3.Cross(gradient, (Double3)away.normalized).Length * Spacing);
                }
                if (count > 1) Assert.That(beside, Is.GreaterThan(0.2), "some are pushed sideways, not only away");
            }
        }

        static Vector3[] Plate(float half)
        {
            var corners = new System.Collections.Generic.List<Vector3>();
            GatherWallsTests.Sheet(corners, p => 2f * half * new Vector3(p.x - 0.5f, 0f, p.y - 0.5f), 3, false);
            return corners.ToArray();
        }

        // 0.1 to 1 spacings from the plate and beyond it, off the direction where a face ends: the slope has a step there.
        static Vector3 Near(float half, System.Random random)
        {
            while (true)
            {
                Vector3 p = 2f * ParticleSets.RandomVector(random);
                p = new Vector3((half + Spacing) * p.x, Spacing * p.y, (half + Spacing) * p.z);
                double beyond = Beyond(p, half), distance = Math.Sqrt(p.y * (double)p.y + beyond * beyond), facing = Math.Abs(p.y) / distance;
                if (beyond > 0.0 && distance > 0.1 * Spacing && distance < Spacing && Math.Abs(facing - 0.98) > 1e-3) return p;
            }
        }

        static double Beyond(Double3 p, double half)
        {
            double x = Math.Max(Math.Abs(p.X) - half, 0.0), z = Math.Max(Math.Abs(p.Z) - half, 0.0);
            return Math.Sqrt(x * x + z * z);
        }

        static Double3 Gradient(Double3 p, double half, in FluidSolverSettings settings)
        {
            const double step = 1e-7;
            double radius = settings.SupportRadius;
            double At(double x, double y, double z) => StandardReference.Plate(Math.Abs(p.Y + y), Beyond(p + new Double3(x, y, z), half), radius, Spacing);
            return 0.5 / step * new Double3(At(step, 0, 0) - At(-step, 0, 0), At(0, step, 0) - At(0, -step, 0), At(0, 0, step) - At(0, 0, -step));
        }
    }
}
