using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The push of walls is the derivative of their share, and the Hessian that of the push, where triangles and faces of the domain meet
    /// and hide each other.
    /// </summary>
    public sealed class WallDerivativesTests
    {
        private const float Spacing = 0.05f, Half = 0.6f, Step = 0.02f * Spacing;

        private static readonly FluidSolverSettings Settings = BodyRig.Water(2f * Half * Vector3.one, Spacing, 0.3f);

        // In the middle of the floor but where another place is named; at the corner of the domain three faces are in reach.
        public enum Place { FlatRamp, SteepRamp, Overhang, Shelf, Post, Chamfer, Gutter, Film, HighRamp, Overlap }

        private static readonly Vector3 Corner = new Vector3(-Half, -Half, -Half), Floor = new Vector3(0.03f, -Half, 0.02f);

        private static IEnumerable<Vector3> Ramp(float degrees)
        {
            Vector3 up = Quaternion.Euler(0f, 0f, degrees) * Vector3.right;
            return Quad(Floor - 0.4f * Vector3.forward, 0.8f * Vector3.forward, up);
        }

        private static IEnumerable<Vector3> Quad(Vector3 a, Vector3 u, Vector3 v) => new[] { a, a + u, a + u + v, a, a + u + v, a + v };

        // Triangles, where the liquid is, and a direction into it from the triangles.
        private static (Vector3[] corners, Vector3 middle, Vector3 into) Scene(Place place)
        {
            switch (place)
            {
                case Place.FlatRamp:
                    return (Ramp(25f).ToArray(), Floor + Spacing * new Vector3(0f, 0.9f, 0f), Quaternion.Euler(0f, 0f, 25f) * Vector3.up);
                case Place.SteepRamp:
                    return (Ramp(65f).ToArray(), Floor + Spacing * new Vector3(-0.5f, 0.9f, 0f),
                        Quaternion.Euler(0f, 0f, 65f) * Vector3.up);
                case Place.Overhang:
                    return (Ramp(115f).ToArray(), Floor + Spacing * new Vector3(-1f, 0.8f, 0f),
                        Quaternion.Euler(0f, 0f, 115f) * Vector3.up);
                case Place.HighRamp:
                    return (Ramp(25f).Select(p => -p).ToArray(), -(Floor + Spacing * new Vector3(0f, 0.9f, 0f)),
                        -(Quaternion.Euler(0f, 0f, 25f) * Vector3.up));
                case Place.Shelf:
                    return (Quad(Floor + 0.35f * Spacing * Vector3.up - 0.4f * Vector3.forward, 0.8f * Vector3.forward,
                        0.5f * Vector3.right).ToArray(), Floor + 1.1f * Spacing * Vector3.up, Vector3.up);
                case Place.Post:
                    return (Quad(Floor, 0.5f * Vector3.right, 0.5f * Vector3.up).ToArray(), Floor + Spacing * new Vector3(0f, 0.9f, 0.8f),
                        Vector3.forward);
                case Place.Chamfer:
                    Vector3 x = 2f * Spacing * Vector3.right, y = 2.4f * Spacing * Vector3.up, z = 1.8f * Spacing * Vector3.forward,
                        n = Vector3.Cross(y - x, z - x).normalized;
                    return (new[] { Corner + x, Corner + y, Corner + z }, Corner + 0.33f * (x + y + z) + 0.8f * Spacing * n, n);
                case Place.Film:
                    return (Quad(-0.4f * new Vector3(1f, 0.3f, 1f), 0.8f * new Vector3(1f, 0.3f, 0f), 0.8f * Vector3.forward).ToArray(),
                        0.05f * Spacing * Vector3.up, new Vector3(-0.3f, 1f, 0f));
                case Place.Overlap: // two floors, one under the other, and a wall that goes through both
                    Vector3 low = new Vector3(-0.3f, 0f, -0.4f);
                    IEnumerable<Vector3> floor = Quad(low, 0.8f * Vector3.forward, 0.8f * Vector3.right);
                    return (floor.Concat(floor.Select(p => p + 0.3f * Spacing * Vector3.down))
                        .Concat(Quad(new Vector3(0f, -0.3f, -0.4f), 0.8f * Vector3.up, 0.8f * Vector3.forward)).ToArray(),
                        Spacing * new Vector3(1.3f, 1.3f, 0f), new Vector3(1f, 1f, 0f));
                default:
                    Vector3 bed = new Vector3(0f, 0.1f, 0f);
                    return (Quad(bed, 0.5f * new Vector3(1f, 0.6f, 0.1f), 0.6f * Vector3.forward)
                        .Concat(Quad(bed, 0.5f * new Vector3(-1f, 0.9f, 0.1f), 0.6f * Vector3.forward)).ToArray(),
                        bed + new Vector3(0f, 0.8f * Spacing, 0.3f), Vector3.up);
            }
        }

        private static Vector3[] Points(Place place, out Vector3[] corners)
        {
            (Vector3[] wall, Vector3 middle, Vector3 into) = Scene(place);
            corners = wall;
            float Away(Vector3 p) => Enumerable.Range(0, wall.Length / 3).Min(t => // 0 behind a triangle's plane
            {
                Vector3 n = Vector3.Cross(wall[3 * t + 1] - wall[3 * t], wall[3 * t + 2] - wall[3 * t]).normalized;
                return Mathf.Max(Vector3.Dot(p - wall[3 * t], Vector3.Dot(n, into) < 0f ? -n : n), 0f);
            });
            float Inside(Vector3 p) => Half - Mathf.Max(Mathf.Abs(p.x), Mathf.Max(Mathf.Abs(p.y), Mathf.Abs(p.z)));
            Vector3 around = Spacing * new Vector3(2.4f, place == Place.Film ? 0.8f : 2.4f, 2.4f); // there nearer than the profile bends
            return ParticleSets.Random(4000, around, 0f, 5).Select(p => middle + p.Position)
                .Where(p => Away(p) > 0.15f * Spacing && (place != Place.Film || Away(p) < 0.5f * Spacing) && Inside(p) > 0.15f * Spacing)
                .Take(400).ToArray();
        }

        [Test]
        public void PushAndHessianAreTheDerivativesOfTheShare([Values] Place place)
        {
            Vector3[] points = Points(place, out Vector3[] corners);
            Assert.That(points, Has.Length.GreaterThan(100));
            using (StandardStateRig rig = WalledStateRig.Create(Settings, corners, points.Length, out CollisionBodies bodies))
            using (bodies)
            {
                Vector3[] at = rig.FillSorted(points.Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray())
                    .Select(p => p.Position).ToArray();
                var random = new System.Random(4);
                Vector3[] steps = at.Select(_ => Step * ParticleSets.RandomVector(random).normalized).ToArray();
                StoredWall[] Walls(float times, bool gathers)
                {
                    rig.State.Buffers.Positions.SetData(at.Select((p, i) => StandardStateRig.WithW(p + times * steps[i], 0f)).ToArray());
                    if (gathers) GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, rig.State, rig.State.Buffers.Positions));
                    return StoredWall.Read(rig.State);
                }
                StoredWall[] here = Walls(0f, true), kept = Walls(1f, false), there = Walls(1f, true), back = Walls(-1f, true);
                double steepest = here.Max(w => w.Push.Length), turning = 0.0;
                List<double> pushes = new List<double>(), turns = new List<double>();
                for (int i = 0; i < at.Length; i++)
                {
                    if (here[i].Value < 0.01) continue;
                    double length = steps[i].magnitude;
                    pushes.Add(Math.Abs((there[i].Value - back[i].Value) / 2.0 - Double3.Dot(here[i].Push, steps[i])) /
                        (steepest * length));
                    Double3 turned = 0.5 * (there[i].Push - back[i].Push),
                        known = new Double3(kept[i].Gradient(0), kept[i].Gradient(1), kept[i].Gradient(2)) - here[i].Push;
                    if (here[i].IsBrief) continue;
                    turning = Math.Max(turning, turned.Length);
                    turns.Add((turned - known).Length);
                }
                double Most(List<double> errors, double part) => errors.OrderBy(e => e).ElementAt((int)(part * errors.Count));
                Assert.That(pushes, Has.Count.GreaterThan(60));
                Assert.That(Most(pushes, 0.5), Is.LessThan(2e-3), "of the steepest push");
                Assert.That(Most(pushes, 0.8), Is.LessThan(0.03), "of the steepest push");
                if (place == Place.Shelf) return; // within reach of a free edge, of which the Hessian has a part only
                Assert.That(turns, Has.Count.GreaterThan(30));
                Assert.That(Most(turns, place == Place.Gutter ? 0.8 : 0.5), Is.LessThan(4e-3 * Math.Max(turning, 0.01 * steepest)),
                    "of what the Hessian changes");
            }
        }
    }
}
