using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// A fill of ten spacings or more holds its volume within two per cent, wherever it is, however it is turned and whether or not layers
    /// fit it.
    /// </summary>
    public sealed class FillVolumeTests
    {
        private const float Spacing = 0.02f;

        private static readonly Vector3[] Offsets = { Vector3.zero, new Vector3(0.25f, 0.5f, 0.31f), new Vector3(0.5f, 0.13f, 0.77f) };
        private static readonly Vector3[] Turns = { Vector3.zero, new Vector3(0f, 1f, 0f), new Vector3(0f, 45f, 0f),
            new Vector3(10f, 35f, 5f) };

        [Test]
        public void AShapeHoldsItsVolume([Values("box", "sphere", "cylinder", "crate")] string shape,
            [Values(10f, 10.5f, 12.3f)] float across)
        {
            foreach (Vector3 turn in Turns)
                foreach (Vector3 offset in Offsets)
                {
                    Matrix4x4 frame = Matrix4x4.TRS(offset * Spacing, Quaternion.Euler(turn), across * Spacing * Vector3.one);
                    LiquidShape liquid = shape == "box" ? new LiquidBox("box", frame, Vector3.zero) : shape == "sphere"
                        ? new LiquidEllipsoid("sphere", frame, Vector3.zero)
                        : (LiquidShape)new LiquidMesh(shape, Cylinder(shape == "crate" ? 4 : 32).Transformed(frame), Vector3.zero);
                    SpawnResult result =
                        FluidSpawner.Fill(new SpawnRequest { DomainSize = Vector3.one, Spacing = Spacing, Shapes = new[] { liquid } });
                    Check(result, liquid.Volume, $"turned by {turn} at {offset}");
                    Assert.That(result.Particles.All(p => liquid.Contains(p.Position)));
                }
        }

        [Test]
        public void AVesselHoldsItsVolume([Values(4, 32)] int sides, [Values(false, true)] bool lies,
            [Values(10f, 10.5f, 20f)] float across)
        {
            foreach (Vector3 turn in across < 20f ? Turns : Turns.Take(3))
                foreach (Vector3 offset in across < 20f ? Offsets : Offsets.Skip(1).Take(1))
                    using (var rig = new ColliderRig { DomainSize = 1.2f * Vector3.one, Spacing = Spacing })
                    {
                        TriangleMesh whole = Cylinder(sides);
                        int[] open = whole.Indices.Take(whole.Indices.Length - 3 * sides).ToArray(),
                            inward = whole.Indices.Reverse().ToArray();
                        Transform vessel = rig
                            .AddMesh(new Mesh
                            {
                                name = "Test Vessel", vertices = whole.Vertices,
                                triangles = lies ? inward : open
                            }).transform;
                        vessel.localScale = across * Spacing * Vector3.one;
                        vessel.SetPositionAndRotation(offset * Spacing,
                            Quaternion.Euler(turn) * (lies ? Quaternion.Euler(0f, 0f, 90f) : Quaternion.identity));
                        rig.Gather();
                        Vector3 seed = offset * Spacing - 0.25f * across * Spacing * Vector3.up;
                        float level = 0.41f * across * Spacing;
                        SpawnResult result = FluidSpawner.Fill(new SpawnRequest
                        {
                            DomainSize = rig.DomainSize, Spacing = Spacing,
                            Obstacle = p => rig.Scene.FindCovering(p, SpawnRequest.ObstacleClearance * Spacing),
                            Shapes = new[]
                            {
                                new LiquidVessel("vessel", new VesselInput
                                {
                                    Seed = seed, Up = Vector3.up, Level = level, DomainSize = rig.DomainSize, Colliders = rig.Scene,
                                    Clearance = SpawnRequest.ObstacleClearance * Spacing,
                                }, Vector3.zero),
                            },
                        });
                        TriangleMesh hull = whole.Transformed(vessel.localToWorldMatrix);
                        Check(result, VolumeBelow(hull, seed.y + level), $"turned by {turn} at {offset}");
                        Assert.That(result.Tallies[0].Carved, Is.Zero, "so that nothing is said");
                        Assert.That(result.Particles.All(p => hull.Contains(p.Position) && p.Position.y < seed.y + level + Spacing));
                    }
        }

        private static void Check(SpawnResult result, double volume, string what)
        {
            Assert.That(result.Particles.Count * Math.Pow(Spacing, 3), Is.EqualTo(volume).Within(2).Percent, what);
            Assert.That(result.Tallies[0].Expected * Math.Pow(Spacing, 3), Is.EqualTo(volume).Within(2).Percent, what);
            var places = new SpacedPoints(Spacing);
            foreach (FluidParticle particle in result.Particles)
            {
                Assert.That(places.HasNear(particle.Position, 0.49f * Spacing), Is.False, $"{what}: {particle.Position}");
                places.Add(particle.Position);
            }
        }

        // By the places where lines along x intersect it.
        private static double VolumeBelow(TriangleMesh hull, float surface)
        {
            const int Lines = 100;
            double chords = 0.0;
            Vector3 min = hull.Bounds.min;
            var step = new Vector2((Mathf.Min(surface, hull.Bounds.max.y) - min.y) / Lines, hull.Bounds.size.z / Lines);
            for (int j = 0; j < Lines; j++)
                for (int k = 0; k < Lines; k++)
                    for (int t = 0; t < hull.TriangleCount; t++)
                    {
                        hull.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                        chords += TriangleMath.LineCrossing(min + new Vector3(0f, (j + 0.5f) * step.x, (k + 0.5f) * step.y), a, b, c,
                            out double x) * (x - min.x);
                    }
            return chords * step.x * step.y;
        }

        // One across and one high, its upper end last; a box of four sides.
        private static TriangleMesh Cylinder(int sides)
        {
            var vertices = new List<Vector3>();
            var sheet = new List<int>();
            var lid = new List<int>();
            double radius = sides == 4 ? Math.Sqrt(0.5) : 0.5;
            for (int i = 0; i < sides; i++)
            {
                double angle = 2.0 * Math.PI * (i + (sides == 4 ? 0.5 : 0.0)) / sides;
                for (int end = 0; end < 2; end++)
                {
                    vertices.Add(new Vector3((float)(radius * Math.Cos(angle)), end - 0.5f, (float)(radius * Math.Sin(angle))));
                }
                int a = 2 * i, b = 2 * ((i + 1) % sides);
                sheet.AddRange(new[] { a, a + 1, b, b, a + 1, b + 1, 2 * sides, a, b });
                lid.AddRange(new[] { 2 * sides + 1, b + 1, a + 1 });
            }
            vertices.Add(0.5f * Vector3.down);
            vertices.Add(0.5f * Vector3.up);
            return new TriangleMesh(vertices.ToArray(), sheet.Concat(lid).ToArray());
        }
    }
}
