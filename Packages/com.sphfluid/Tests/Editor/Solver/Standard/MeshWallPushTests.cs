using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What planes of meshes add to a particle's density, and how they push it, against a reference in double precision.</summary>
    public sealed class MeshWallPushTests
    {
        private const float Spacing = 0.05f;
        private const float Pressure = 4e-3f; // over the square of the density

        // A place away from where the walls were gathered, with a Hessian of any kind: the push is the gradient of what they add there.
        [Test]
        public void ThePushOfKeptWallsIsTheGradientOfTheirShare([Values(1, 2, 3)] int planes, [Values(1, 63, 64, 65, 257)] int count)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Vector3.one, Spacing);
            settings.Gravity = Vector3.zero;
            var random = new System.Random(10 * count + planes);
            Vector3 Any() => ParticleSets.RandomVector(random);
            uint Halves() => Mathf.FloatToHalf(20f * Any().x) | (uint)Mathf.FloatToHalf(20f * Any().y) << 16;
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.5f * Vector3.one, 0f, 5));
                rig.State.List.Counts.SetData(new uint[count]); // nobody has a neighbour
                WalledStateRig.SetWalls(rig, particles.Select(p =>
                {
                    StoredWall.Packed wall =
                        StoredWall.Pack(p.Position, false, 0.2f, new[] { Any() / Spacing, Any() / Spacing, Any() / Spacing },
                        Enumerable.Range(0, planes).Select(_ => (Any().normalized, (0.3f + 0.7f * (float)random.NextDouble()) * Spacing))
                            .ToArray());
                    wall.Origin += 0.1f * settings.SupportRadius * Any();
                    (wall.HessianXXYY, wall.HessianZZYZ, wall.HessianZXXY) = (Halves(), Halves(), Halves());
                    return wall;
                }).ToList());
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, Pressure), count).ToArray());
                float step = settings.TimeStep;
                GpuTest.Run(cmd => new MoveParticlesPass(rig.Shaders).Record(cmd, rig.State, new FluidStep(step, step, false)));
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
                StoredWall[] walls = StoredWall.Read(rig.State);
                double push = settings.RestDensity * Pressure / StandardReference.Response(settings) * step, turned = 0.0;
                for (int i = 0; i < count; i++)
                {
                    var expected = new Double3(-push * walls[i].Gradient(0), -push * walls[i].Gradient(1), -push * walls[i].Gradient(2));
                    Assert.That(((Double3)(Vector3)velocities[i] - expected).Length, Is.LessThan(1e-3 * push / Spacing), $"particle {i}");
                    turned = Math.Max(turned, (expected + push * walls[i].Push).Length / (push * walls[i].Push).Length);
                }
                Assert.That(turned, Is.GreaterThan(0.1), "the Hessian acts");
            }
        }

        // Round the edges and corners of a plate, as the walls are gathered.
        [Test]
        public void ThePushRoundAFreeEdgeIsTheGradientOfWhatItAdds([Values(1, 63, 64, 65, 257)] int count)
        {
            const float half = 0.15f;
            FluidSolverSettings settings = StandardStateRig.Water(Vector3.one, Spacing);
            settings.Gravity = Vector3.zero;
            var random = new System.Random(count);
            Vector3[] plate = Plate(half);
            Double3[] above = plate.Select(p => (Double3)p).ToArray(), below = above.Reverse().ToArray();
            if (Double3.Cross(above[1] - above[0], above[2] - above[0]).Y < 0.0) (above, below) = (below, above);
            using (StandardStateRig rig = WalledStateRig.Create(settings, plate, count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(Enumerable.Range(0, count)
                    .Select(i => new FluidParticle(Near(half, random), Vector3.zero, (uint)i)).ToArray());
                GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, rig.State, rig.State.Buffers.Positions));
                rig.State.List.Counts.SetData(new uint[count]); // nobody has a neighbour
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, Pressure), count).ToArray());
                float step = settings.TimeStep;
                GpuTest.Run(cmd => new MoveParticlesPass(rig.Shaders).Record(cmd, rig.State, new FluidStep(step, step, false)));
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
                double push = settings.RestDensity * Pressure / StandardReference.Response(settings) * step, beside = 0.0;
                for (int i = 0; i < count; i += 1 + count / 40)
                {
                    Vector3 at = particles[i].Position;
                    Double3 gradient = ShadowReference.Gradient(at, at.y > 0f ? above : below, settings.SupportRadius, Spacing);
                    Assert.That(((Double3)(Vector3)velocities[i] + push * gradient).Length, Is.LessThan(0.03 * push / Spacing), $"at {at}");
                    beside = Math.Max(beside, Math.Sqrt(gradient.X * gradient.X + gradient.Z * gradient.Z) * Spacing);
                }
                if (count > 1) Assert.That(beside, Is.GreaterThan(0.2), "some are pushed sideways, not only away");
            }
        }

        private static Vector3[] Plate(float half)
        {
            var corners = new System.Collections.Generic.List<Vector3>();
            for (int y = 0; y < 3; y++)
                for (int x = 0; x < 3; x++)
                {
                    Vector3 At(int u, int v) => 2f * half * new Vector3(u / 3f - 0.5f, 0f, v / 3f - 0.5f);
                    corners.AddRange(new[] { At(x, y), At(x + 1, y + 1), At(x + 1, y), At(x, y), At(x, y + 1), At(x + 1, y + 1) });
                }
            return corners.ToArray();
        }

        // Round the rim, 0.3 to 1 spacings off the plate's plane.
        private static Vector3 Near(float half, System.Random random)
        {
            while (true)
            {
                Vector3 p = 2f * ParticleSets.RandomVector(random);
                p = new Vector3((half + 0.5f * Spacing) * p.x, Spacing * p.y, (half + 0.5f * Spacing) * p.z);
                float inside = Mathf.Min(half - Mathf.Abs(p.x), half - Mathf.Abs(p.z));
                if (Mathf.Abs(p.y) > 0.3f * Spacing && Mathf.Abs(p.y) < Spacing && Mathf.Abs(inside) < 0.6f * Spacing) return p;
            }
        }
    }
}
