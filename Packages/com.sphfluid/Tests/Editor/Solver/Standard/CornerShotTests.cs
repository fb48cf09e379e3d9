using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Single drops, far from each other, shot into corners, without gravity: walls that stand still, however they overlap, give none more
    /// speed than it came with.
    /// </summary>
    public sealed class CornerShotTests
    {
        private const float Spacing = 0.02f;
        private const int Shots = 120;
        private const float Apart = 3f * 2.25f * Spacing;

        public enum Corner { OneMesh, OverlappingBoxes, StackedFloors, SheetOverFloor, ThreeBoxes, Wedge, WedgeOfOne }

        // Along x, the corner at y = z = 0, liquid where both are above zero.
        private static void Build(BodyRig rig, Corner corner)
        {
            float length = Apart * Shots + 1f;
            Transform Box(Vector3 centre, Vector3 size, float turn = 0f)
            {
                Transform box = rig.AddBox(size);
                box.localRotation = Quaternion.AngleAxis(turn, Vector3.right);
                box.localPosition = box.localRotation * centre;
                return box;
            }
            var deep = new Vector3(length, 0.4f, 0.8f);
            var wide = new Vector3(length, 0.8f, 0.4f);
            switch (corner)
            {
                case Corner.OneMesh:
                    var a = new Vector3(-0.5f * length, 0f, 0f);
                    var b = new Vector3(0.5f * length, 0f, 0f);
                    Vector3 up = 0.4f * Vector3.up, forward = 0.4f * Vector3.forward;
                    rig.Add(new[] { a, b, a + up, b, b + up, a + up, a, a + forward, b, b, a + forward, b + forward });
                    break;
                case Corner.OverlappingBoxes:
                    Box(new Vector3(0f, -0.2f, 0.2f), deep);
                    Box(new Vector3(0f, 0.2f, -0.2f), wide);
                    break;
                case Corner.StackedFloors:
                    Box(new Vector3(0f, -0.2f, 0.2f), deep);
                    Box(new Vector3(0f, -0.2f - 0.3f * Spacing, 0.2f), deep);
                    Box(new Vector3(0f, 0.2f, -0.2f), wide);
                    break;
                case Corner.SheetOverFloor:
                    Vector3 c = new Vector3(-0.5f * length, 0.05f * Spacing, -0.2f), d = c + length * Vector3.right;
                    rig.Add(new[] { c, c + 0.6f * Vector3.forward, d, d, c + 0.6f * Vector3.forward, d + 0.6f * Vector3.forward });
                    Box(new Vector3(0f, -0.2f - 0.25f * Spacing, 0.2f), deep);
                    Box(new Vector3(0f, 0.2f, -0.2f), wide);
                    break;
                case Corner.ThreeBoxes:
                    Box(new Vector3(0f, -0.2f, 0.2f), deep);
                    Box(new Vector3(0f, -0.2f, 0.2f), deep, -20f); // rises from the corner on
                    Box(new Vector3(0f, 0.2f, -0.2f), wide);
                    break;
                case Corner.Wedge:
                    Box(new Vector3(0f, -0.2f, 0.2f), deep);
                    Box(new Vector3(0f, 0.2f, -0.2f), wide, 50f);
                    break;
                default:
                    Vector3 slope = new Vector3(0f, Mathf.Cos(50f * Mathf.Deg2Rad), Mathf.Sin(50f * Mathf.Deg2Rad)) * 0.4f;
                    var e = new Vector3(-0.5f * length, 0f, 0f);
                    var f = new Vector3(0.5f * length, 0f, 0f);
                    Vector3 along = 0.4f * Vector3.forward;
                    rig.Add(new[] { e, f, e + slope, f, f + slope, e + slope, e, e + along, f, f, e + along, f + along });
                    break;
            }
        }

        [Test]
        public void NoDropLeavesACornerFasterThanItCame([Values] Corner corner, [Values(0.05f, 0.2f)] float speed)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(Apart * Shots + 1.2f, 1.2f, 1.2f), Spacing, 0.3f);
            settings.Gravity = Vector3.zero;
            float fast = speed * settings.SoundSpeed;
            var random = new System.Random(5);
            float lowest = corner == Corner.ThreeBoxes ? 20f : 0f;
            float highest = corner == Corner.Wedge || corner == Corner.WedgeOfOne ? 40f : 90f;
            FluidParticle[] start = Enumerable.Range(0, Shots).Select(i =>
            {
                float angle = Mathf.Deg2Rad * Mathf.Lerp(lowest + 5f, highest - 5f, (float)random.NextDouble());
                var from = 6f * Spacing * new Vector3(0f, Mathf.Sin(angle), Mathf.Cos(angle));
                Vector3 to = 1.5f * Spacing * new Vector3(0f, (float)random.NextDouble(), (float)random.NextDouble());
                return new FluidParticle(from + (i + 0.5f - 0.5f * Shots) * Apart * Vector3.right, fast * (to - from).normalized, (uint)i);
            }).ToArray();
            using (var rig = new BodyRig(settings))
            {
                Build(rig, corner);
                rig.Start(start);
                var most = new float[Shots];
                float dense = 0f;
                int steps = (int)(14f * Spacing / fast / settings.TimeStep);
                for (int step = 0; step < steps; step++)
                {
                    rig.Frame(1);
                    foreach (FluidParticle p in rig.Particles()) most[p.Id] = Mathf.Max(most[p.Id], p.VelT0.magnitude / fast);
                    dense = Mathf.Max(dense, rig.Densities().Max() / settings.RestDensity);
                }
                FluidCounters counters = rig.Solver.ReadCountersNow();
                string figures = $"{fast * settings.TimeStep / Spacing:f2} dx a step, fastest {most.Max():f2}, faster " +
                    $"{most.Count(m => m > 1.03f)}, densest {dense:f3}, contacts {counters.Contacts}";
                TestContext.WriteLine(figures);
                Assert.That(most.Max(), Is.LessThan(1.03f), figures);
                Assert.That(most.Min(), Is.GreaterThan(0.99f), figures);
                Assert.That(counters.NonFinite + counters.Squeezed, Is.Zero, figures);
            }
        }
    }
}
