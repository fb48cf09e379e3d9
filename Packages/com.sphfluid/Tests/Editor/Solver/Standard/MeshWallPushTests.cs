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
    }
}
