using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// A closed skin that waves with liquid on both sides of it: nothing crosses. Who is where is found from corners and places alone.
    /// </summary>
    public sealed class DeformingLeakTests
    {
        private const float Spacing = 0.03f, Radius = 0.2f, Hertz = 3f;

        // By a fifth of the radius, in waves that run round the ball.
        private static TriangleMesh Waved(TriangleMesh ball, float time) => ball.Deformed(ball.Vertices
            .Select(v =>
                (1f + 0.2f * Mathf.Sin(2f * Mathf.PI * Hertz * time + 4f * Mathf.Atan2(v.z, v.x) + 5f * v.y / Radius) *
                    Mathf.Min(1f, 2f * new Vector2(v.x, v.z).magnitude / Radius)) * v)
            .ToArray());

        // In fewer steps a frame than the liquid's own the skin is that much faster to it.
        [TestCase(0.01f, true, 6)]
        [TestCase(0.01f, false, 4)]
        [TestCase(0.002f, false, 2)]
        [TestCase(0.01f, false, 1)]
        public void NothingCrossesASkinThatWaves(float chordError, bool dense, int steps)
        {
            Vector3 domain = new Vector3(17, 20, 17) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 12 * Spacing, 5f);
            TriangleMesh ball = PrimitiveTessellator.Capsule(Matrix4x4.identity, Radius, 0f, chordError), skin = Waved(ball, 0f);
            Assert.That(skin.IsClosed);
            Vector3Int counts = dense ? new Vector3Int(17, 12, 17) : new Vector3Int(6, 7, 6);
            FluidParticle[] water = FloatingRig.Block(counts, dense ? Spacing : 3f * Spacing, -0.5f * domain)
                .Where(p => !skin.IsNear(p.Position, 0.45f * Spacing)).ToArray();
            for (int i = 0; i < water.Length; i++) water[i].Id = (uint)i;
            bool[] inside = water.Select(p => skin.Contains(p.Position)).ToArray();
            Assert.That(inside.Count(b => b), Is.GreaterThan(dense ? 100 : 15));
            using (var obstacles = new FluidObstacles(settings))
            using (var liquid = new StandardRig(settings, water))
            {
                int mesh = obstacles.Add(skin, Matrix4x4.identity);
                var crossed = new HashSet<int>();
                var passed = new HashSet<int>();
                float turned = 0f;
                for (int frame = 0; frame < 7; frame++)
                {
                    skin = Waved(ball, frame / 60f);
                    if (frame > 4) turned += 3f;
                    Matrix4x4 pose = Matrix4x4.TRS(0.001f * turned * Vector3.up, Quaternion.Euler(0f, turned, 0f), Vector3.one);
                    obstacles.Reshape(mesh, skin);
                    obstacles.MoveTo(mesh, pose);
                    obstacles.Update(Matrix4x4.identity);
                    liquid.Solver.SetObstacles(obstacles);
                    liquid.Steps(steps);
                    TriangleMesh now = skin.Transformed(pose);
                    foreach (FluidParticle p in liquid.Particles())
                        if (now.Contains(p.Position) != inside[p.Id]) crossed.Add((int)p.Id);
                    for (int i = 0; i < water.Length; i++)
                        if (now.Contains(water[i].Position) != inside[i]) passed.Add(i);
                }
                FluidCounters counters = liquid.Solver.ReadCountersNow();
                TestContext.WriteLine(
                    $"{skin.TriangleCount} triangles, {water.Length} particles, {inside.Count(b => b)} inside, the skin passed the first " +
                    $"place of {passed.Count}, {crossed.Count} crossed, contacts {counters.Contacts}, fell back " +
                    $"{counters.ContactFallbacks}, squeezed {counters.Squeezed}, overlaps {counters.Overlaps}, shortened " +
                    $"{counters.ShortenedSteps}");
                Assert.That(obstacles.Jumps, Is.Zero);
                Assert.That(counters.NonFinite, Is.Zero);
                Assert.That(passed.Count, Is.GreaterThan(inside.Count(b => b) / 10), "where the skin passes there was liquid");
                Assert.That(counters.Squeezed, Is.Zero);
                Assert.That(crossed, Is.Empty);
            }
        }
    }
}
