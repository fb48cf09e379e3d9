using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Colliders in liquid of the Robust method: nothing crosses them, they may move, and the liquid moves them.</summary>
    public sealed class RobustBodiesTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(1f, 1.2f, 0.8f);

        private static FluidSolverSettings Settings(float speed = 0f) =>
            BodyRig.Water(Domain, Spacing, 0.4f, speed, FluidMethodKind.Robust);

        private static FluidParticle[] Block(Vector3 velocity)
        {
            FluidParticle[] block = ParticleSets.Lattice(new Vector3Int(8, 7, 8), Spacing, 0.02f * Spacing, 3);
            for (int i = 0; i < block.Length; i++) block[i] = new FluidParticle(block[i].Position, velocity, block[i].Id);
            return block;
        }

        // A sheet of two triangles, thinner than anything, in the way of liquid that goes up to four spacings a step.
        [TestCase(4f, 4)]
        [TestCase(12f, 4)]
        [TestCase(12f, 1)]
        public void NothingPassesASheet(float speed, int substeps)
        {
            float y = -0.35f;
            using (var rig = new BodyRig(Settings(speed)))
            {
                Vector3 a = new Vector3(-0.6f, y, -0.5f), b = new Vector3(-0.6f, y, 0.5f), c = new Vector3(0.6f, y, 0.5f),
                    d = new Vector3(0.6f, y, -0.5f);
                rig.Add(new[] { a, b, c, a, c, d });
                FluidParticle[] start = Block(speed * Vector3.down);
                rig.Start(start);
                for (int frame = 0; frame < 20; frame++)
                {
                    float length = 1f / (60f * substeps);
                    rig.UpdateBodies();
                    GpuTest.Run(cmd =>
                    {
                        rig.Solver.RecordSteps(cmd, substeps, length);
                        rig.Solver.RecordNeighbourSetup(cmd);
                    });
                }
                FluidParticle[] after = rig.Particles();
                FluidCounters counters = rig.Solver.ReadCountersNow();
                Assert.That(after.Count(p => p.Position.y > y), Is.EqualTo(start.Length), "all above the sheet");
                Assert.That(after.All(p => p.VelT0.magnitude < 2f * speed + 5f));
                Assert.That(counters.NonFinite + counters.Squeezed, Is.Zero);
                Assert.That(after.Select(p => p.Id).Distinct().Count(), Is.EqualTo(start.Length));
            }
        }

        [Test]
        public void AMovingPlateCarriesTheLiquidAlong()
        {
            using (var rig = new BodyRig(Settings(2f)))
            {
                Transform plate = rig.AddBox(new Vector3(0.06f, 1.3f, 0.9f));
                plate.localPosition = new Vector3(-0.3f, 0f, 0f);
                FluidParticle[] start = Block(Vector3.zero).Where(p => p.Position.x > -0.2f)
                    .Select((p, i) => new FluidParticle(p.Position - 0.4f * Vector3.up, Vector3.zero, (uint)i)).ToArray();
                rig.Start(start);
                for (int frame = 0; frame < 24; frame++)
                {
                    plate.localPosition += new Vector3(0.0125f, 0f, 0f); // 0.75 m/s
                    rig.Frame(4);
                }
                FluidParticle[] after = rig.Particles();
                Assert.That(after.Min(p => p.Position.x), Is.GreaterThan(plate.localPosition.x), "nobody is behind the plate");
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
                Assert.That(after.Average(p => p.Position.x), Is.GreaterThan(start.Average(p => p.Position.x) + 0.05f));
            }
        }

        [Test]
        public void ATankOfTrianglesHoldsALevelAsTheDomainDoes()
        {
            double Height(bool mesh)
            {
                FluidSolverSettings settings =
                    BodyRig.Water(mesh ? new Vector3(1f, 1f, 1f) : new Vector3(0.3f, 1f, 0.3f), Spacing, 0.4f, 0f, FluidMethodKind.Robust);
                using (var rig = new BodyRig(settings))
                {
                    if (mesh)
                    {
                        Vector3 half = new Vector3(0.15f, 0.45f, 0.15f);
                        void Quad(Vector3 o, Vector3 u, Vector3 v) => rig.Add(new[] { o, o + u, o + u + v, o, o + u + v, o + v });
                        Quad(-half, 2f * half.x * Vector3.right, 2f * half.z * Vector3.forward);
                        Quad(-half, 2f * half.x * Vector3.right, 2f * half.y * Vector3.up);
                        Quad(-half, 2f * half.z * Vector3.forward, 2f * half.y * Vector3.up);
                        Quad(new Vector3(-half.x, -half.y, half.z), 2f * half.x * Vector3.right, 2f * half.y * Vector3.up);
                        Quad(new Vector3(half.x, -half.y, -half.z), 2f * half.z * Vector3.forward, 2f * half.y * Vector3.up);
                    }
                    float floor = mesh ? -0.45f : -0.5f;
                    FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(6, 8, 6), Spacing, 0.02f * Spacing, 3);
                    for (int i = 0; i < start.Length; i++)
                    {
                        start[i] = new FluidParticle(start[i].Position + (floor + 0.2f) * Vector3.up, Vector3.zero, start[i].Id);
                    }
                    rig.Start(start);
                    for (int frame = 0; frame < 60; frame++) rig.Frame(4);
                    Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
                    FluidParticle[] after = rig.Particles();
                    Assert.That(after.Count(p => Mathf.Max(Mathf.Abs(p.Position.x), Mathf.Abs(p.Position.z)) < 0.15f &&
                        p.Position.y > floor), Is.EqualTo(start.Length));
                    Assert.That(after.Max(p => p.VelT0.magnitude), Is.LessThan(0.3f), "calm");
                    return 2.0 * after.Average(p => (double)p.Position.y - floor);
                }
            }
            double domain = Height(false), triangles = Height(true);
            TestContext.Out
                .WriteLine($"height {domain:0.0000} m in the domain, {triangles:0.0000} m between triangles, 0.4 m at the start");
            Assert.That(triangles, Is.EqualTo(domain).Within(0.1 * Spacing));
        }

        // FloatingCrateTests has a heavier one too; that is the liquid's business, the light one the coupling's.
        [TestCase(0.1f)]
        public void ACrateFloatsUprightAsDeepAsItIsHeavy(float ratio)
        {
            using (var tank = new FloatingTank(0.06f, 13, 7, 0.3f * new Vector3(1.5f, 1f, 1.5f), ratio, 0.3f * (0.55f - ratio),
                Quaternion.Euler(5f, 0f, 3f), FluidMethodKind.Robust))
            {
                tank.Play(1.2);
                string figures = tank.Figures(0.5);
                TestContext.Out.WriteLine(figures);
                Assert.That(tank.Tilt, Is.LessThan(8.0), figures);
                Assert.That(tank.Draught(0.5), Is.EqualTo(ratio).Within(0.5 * 0.06 / 0.3), figures); // half a spacing
                Assert.That(tank.Speed(0.5), Is.LessThan(0.075), figures);
            }
        }
    }
}
