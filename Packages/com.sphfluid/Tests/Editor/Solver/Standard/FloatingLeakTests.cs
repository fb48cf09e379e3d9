using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Hollow boxes with liquid in them, afloat in liquid, kicked and spun: what is inside stays inside, what is outside stays outside. Who
    /// is where is told from the bodies' poses and the particles' places alone.
    /// </summary>
    public sealed class FloatingLeakTests
    {
        private const float Spacing = 0.03f, Wall = 0.02f;

        private static readonly Vector3 Outer = new Vector3(0.24f, 0.18f, 0.2f);
        private static readonly Vector3 Inner = Outer - 2f * Wall * Vector3.one;

        private enum Place
        {
            Inside,
            InWall,
            Outside,
        }

        // Two closed surfaces, the inner one seen from within.
        private static TriangleMesh Hollow()
        {
            TriangleMesh outer = TriangleMesh.Box(Matrix4x4.Scale(Outer)), inner = TriangleMesh.Box(Matrix4x4.Scale(Inner));
            int[] turned = inner.Indices.Reverse().Select(i => i + outer.Vertices.Length).ToArray();
            return new TriangleMesh(outer.Vertices.Concat(inner.Vertices).ToArray(), outer.Indices.Concat(turned).ToArray());
        }

        private static Place Of(Vector3 position, in FloatingPose pose)
        {
            Vector3 local = pose.ToBody(position), beyondInner = Abs(local) - 0.5f * Inner, beyondOuter = Abs(local) - 0.5f * Outer;
            if (Mathf.Max(beyondInner.x, Mathf.Max(beyondInner.y, beyondInner.z)) <= 0f) return Place.Inside;
            return Mathf.Max(beyondOuter.x, Mathf.Max(beyondOuter.y, beyondOuter.z)) < 0f ? Place.InWall : Place.Outside;
        }

        private static Vector3 Abs(Vector3 v) => new Vector3(Mathf.Abs(v.x), Mathf.Abs(v.y), Mathf.Abs(v.z));

        // Kicked hard, the boxes hit each other and the faces of the domain, and liquid between them has no place.
        // The heavy one has no weight: it would go through the floor, which holds liquid only, and press what is inside against it.
        [TestCase(0.2f, 1, 2f)]
        [TestCase(5f, 4, 5f)]
        public void NothingCrossesTheWallOfABoxThatIsKickedAndSpun(float ratio, int seed, float kick)
        {
            var domain = new Vector3(28, 20, 12) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 12 * Spacing, 5f);
            FloatingPose[] poses = { new FloatingPose(new Vector3(-0.2f, -0.1f, 0f), Quaternion.Euler(10f, 20f, 0f)),
                new FloatingPose(new Vector3(0.2f, -0.1f, 0f), Quaternion.Euler(0f, -30f, 15f)) };
            FluidParticle[] water = FloatingRig.Block(new Vector3Int(28, 11, 12), Spacing, -0.5f * domain)
                .Where(p => poses.All(pose => IsFree(p.Position, pose))).ToArray();
            for (int i = 0; i < water.Length; i++) water[i].Id = (uint)i;
            using (var rig = new FloatingRig(settings, water))
            {
                TriangleMesh hollow = Hollow();
                Assert.That(hollow.IsClosed);
                var bodies = new List<FloatingBody>();
                foreach (FloatingPose pose in poses)
                {
                    var body =
                        new FloatingBody(FloatingMass.Box(Outer, ratio * settings.RestDensity,
                            ratio > 1f ? Vector3.zero : settings.Gravity), pose);
                    rig.Obstacles.Float(rig.Obstacles.Add(hollow, Matrix4x4.TRS(pose.Centre, pose.Rotation, Vector3.one), 0f), body);
                    bodies.Add(body);
                }
                Place[][] before = bodies.Select((b, i) => water.Select(p => Of(p.Position, poses[i])).ToArray()).ToArray();
                Assert.That(before.Sum(b => b.Count(p => p == Place.Inside)), Is.GreaterThan(40));
                Assert.That(before.Sum(b => b.Count(p => p == Place.InWall)), Is.Zero);
                var random = new System.Random(seed);
                float farthest = 0f;
                var crossed = new HashSet<int>();
                for (int frame = 0; frame < 8; frame++)
                {
                    if (frame % 4 == 1)
                        foreach (FloatingBody body in bodies)
                            body.Push(kick * ParticleSets.RandomVector(random), 10f * kick * ParticleSets.RandomVector(random),
                                Vector3.zero, Vector3.zero);
                    rig.Frame(Mathf.CeilToInt(1f / 60f / settings.TimeStep));
                    FluidParticle[] now = rig.Particles().OrderBy(p => p.Id).ToArray();
                    Assert.That(now.Length, Is.EqualTo(water.Length));
                    for (int b = 0; b < bodies.Count; b++)
                    {
                        FloatingPose pose = rig.Read(bodies[b]).Pose;
                        farthest = Mathf.Max(farthest, (pose.Centre - poses[b].Centre).magnitude);
                        for (int i = 0; i < now.Length; i++)
                            if (Of(now[i].Position, pose) != before[b][i]) crossed.Add(i);
                    }
                }
                FluidCounters counters = rig.Solver.ReadCountersNow();
                TestContext.WriteLine(
                    $"{water.Length} particles, bodies went {farthest} m, crossed {crossed.Count}, contacts {counters.Contacts}, " +
                    $"squeezed {counters.Squeezed}, overlaps {counters.Overlaps}, shortened {counters.ShortenedSteps}");
                Assert.That(farthest, Is.GreaterThan(Wall), "more than a wall is thick");
                Assert.That(counters.NonFinite, Is.Zero);
                Assert.That(crossed.Count, Is.LessThanOrEqualTo(counters.Squeezed),
                    "a message names those for which two walls left no place");
                if (kick < 3f) Assert.That(crossed, Is.Empty);
            }
        }

        // Half a spacing from the walls, as a fill leaves it.
        private static bool IsFree(Vector3 position, in FloatingPose pose)
        {
            Vector3 local = Abs(pose.ToBody(position)), inner = local - 0.5f * Inner + 0.4f * Spacing * Vector3.one,
                outer = local - 0.5f * Outer - 0.4f * Spacing * Vector3.one;
            return Mathf.Max(inner.x, Mathf.Max(inner.y, inner.z)) < 0f || Mathf.Max(outer.x, Mathf.Max(outer.y, outer.z)) > 0f;
        }
    }
}
