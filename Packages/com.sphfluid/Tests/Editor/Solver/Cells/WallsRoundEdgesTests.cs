using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Round the edges of solids what walls add changes smoothly: what comes into view on one side ends the solid on the other before.
    /// </summary>
    public sealed class WallsRoundEdgesTests
    {
        private const float Spacing = 0.05f;

        // Of a closed box about the origin.
        private static List<Vector3> Box(Vector3 size)
        {
            Mesh cube = TestMeshes.Cube();
            Vector3[] corners = cube.vertices;
            List<Vector3> box = cube.triangles.Select(i => Vector3.Scale(corners[i], size)).ToList();
            UnityEngine.Object.DestroyImmediate(cube);
            return box;
        }

        // Places beside the edge between the faces at +x and +y, just above and just below the plane of the upper one.
        private static Vector3[] BesideEdge(Vector3 size, float above)
        {
            var random = new System.Random(2);
            return Enumerable.Range(0, 100)
                .Select(_ => 0.5f * size +
                    Spacing * new Vector3(0.3f + 0.5f * (float)random.NextDouble(), above, -2f - 2f * (float)random.NextDouble()))
                    .ToArray();
        }

        [TestCase(6f, true)]
        [TestCase(2.4f, true)] // beyond 2.25 dx nothing is felt
        [TestCase(0.8f, false)] // a plate: of its rim only the side counts that liquid sees
        public void BesideAnEdgeThePushHasNoJump(float width, bool isDeep)
        {
            Vector3 size = Spacing * new Vector3(6f, width, 12f);
            StoredWall[] above = WallEnergyTests.Gather(Box(size), BesideEdge(size, 0.002f)),
                below = WallEnergyTests.Gather(Box(size), BesideEdge(size, -0.002f));
            double jump = Enumerable.Range(0, above.Length).Max(i => (above[i].Push - below[i].Push).Length),
                push = above.Max(w => w.Push.Length);
            TestContext.WriteLine($"{jump / push:f3} of the push");
            Assert.That(push, Is.GreaterThan(0.1 / Spacing));
            Assert.That(jump, isDeep ? Is.LessThan(0.03 * push) : Is.GreaterThan(0.1 * push));
        }

        // As far as the solid is felt: what is behind a plane, less what is beside it.
        [Test]
        public void AWideBoxIsAWallAndAPlateToo([Values(6f, 2.4f, 0.8f, 0.01f)] float width)
        {
            Vector3 size = Spacing * new Vector3(12f, width, 12f);
            Vector3[] over = Enumerable.Range(0, 20).Select(i => new Vector3(0.01f, 0.5f * size.y + (0.3f + 0.04f * i) * Spacing, 0.02f))
                .ToArray();
            StoredWall[] box = WallEnergyTests.Gather(Box(size), over),
                wall = WallEnergyTests.Gather(Box(Spacing * new Vector3(20f, 6f, 20f)),
                    over.Select(p => p + (0.5f * 6f * Spacing - 0.5f * size.y) * Vector3.up).ToArray());
            for (int i = 0; i < over.Length; i++) Assert.That(box[i].Value, Is.EqualTo(wall[i].Value).Within(1e-4), $"{i}");
            Assert.That(box[0].Value, Is.GreaterThan(0.1));
        }

        [Test]
        public void WaterRoundABoxRests([Values(0f, 0.08f)] float above)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.7f, 0.6f, 0.5f), Spacing, 0.2f);
            using (var rig = new BodyRig(settings))
            {
                const float size = 0.22f;
                Transform box = rig.AddBox(size * Vector3.one);
                box.localPosition = new Vector3(0.03f, -0.3f + 0.5f * size + above, 0.02f);
                box.localRotation = Quaternion.Euler(0f, 33f, 0f);
                bool IsOut(Vector3 p)
                {
                    Vector3 q = Quaternion.Inverse(box.localRotation) * (p - box.localPosition);
                    return Mathf.Max(Mathf.Abs(q.x), Mathf.Max(Mathf.Abs(q.y), Mathf.Abs(q.z))) > 0.5f * size + 0.4f * Spacing;
                }
                rig.Start(ParticleSets.Lattice(new Vector3Int(14, 5, 10), Spacing, 0.02f * Spacing, 3)
                    .Select(p => p.Position - (0.3f - 2.5f * Spacing) * Vector3.up)
                    .Where(IsOut).Select((p, i) => new FluidParticle(p, Vector3.zero, (uint)i)).ToArray());
                int steps = Mathf.CeilToInt(6f / settings.TimeStep);
                for (int frame = 0; frame < steps / 8; frame++) rig.Frame(8);
                double speed = Math.Sqrt(rig.Particles().Average(p => (double)p.VelT0.sqrMagnitude));
                TestContext.WriteLine($"{speed:f4} m/s after {steps} steps");
                Assert.That(speed, Is.LessThan(0.016));
            }
        }
    }
}
