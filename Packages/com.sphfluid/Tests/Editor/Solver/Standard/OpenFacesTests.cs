using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Faces through which liquid leaves: whoever is beyond one is removed and counted, everybody else stays, and no wall is felt there.
    /// </summary>
    public sealed class OpenFacesTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(0.4f, 0.6f, 0.35f);

        private static FluidSolverSettings Settings(FluidFaces open, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.4f);
            settings.Boundaries.Open = open;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        private static FluidParticle[] Block() => ParticleSets.Lattice(new Vector3Int(7, 8, 6), Spacing, 0.02f * Spacing, 5);

        [TestCase(FluidFaces.LowY, FluidAxes.None, true)]
        [TestCase(FluidFaces.LowY, FluidAxes.X | FluidAxes.Z, false)]
        [TestCase(FluidFaces.LowY | FluidFaces.HighX, FluidAxes.None, false)]
        public void WhatPoursOutIsCountedAndTheRestStays(FluidFaces open, FluidAxes periodic, bool stable)
        {
            FluidSolverSettings settings = Settings(open, periodic);
            settings = settings.WithOwn((ref StandardSettings own) => own.StableOrder = stable);
            FluidParticle[] start = Block();
            using (var rig = new StandardRig(settings, start))
            {
                long before = 0;
                bool some = false;
                for (int turn = 0; turn < 12; turn++)
                {
                    rig.Steps(60);
                    FluidParticle[] particles = rig.Particles();
                    int live = particles.TakeWhile(p => !p.IsRemoved).Count();
                    FluidCounters counters = rig.Solver.ReadCountersNow();
                    Assert.That(particles.Take(live).Select(p => p.Id), Is.Unique.And.SubsetOf(start.Select(p => p.Id)),
                        "nobody is doubled");
                    Assert.That(particles.Skip(live).All(p => p.IsRemoved), "they stand behind all others");
                    Assert.That(counters.Removed, Is.EqualTo(start.Length - live).And.GreaterThanOrEqualTo(before));
                    Assert.That(particles.Take(live).All(p => IsInside(p.Position)));
                    Assert.That(Listed(rig.Solver), Is.EqualTo(live), "cells hold the liquid alone");
                    Assert.That(rig.Densities().Skip(live), Is.All.Zero);
                    Assert.That(counters.NonFinite, Is.Zero);
                    before = counters.Removed;
                    some |= live > 0 && live < start.Length;
                }
                Assert.That(some, "between the first that leaves and the last there is a time to look at");
                Assert.That(before, Is.EqualTo(start.Length), "and in the end the box is empty");
            }
        }

        // What stands on the face is not beyond it.
        [TestCase(FluidFaces.LowX, -1f)]
        [TestCase(FluidFaces.HighX, 1f)]
        public void OnTheFaceItselfAParticleStays(FluidFaces open, float side)
        {
            FluidSolverSettings settings = Settings(open);
            settings.Gravity = Vector3.zero;
            using (var rig =
                new StandardRig(settings, new[] { new FluidParticle(new Vector3(side * 0.5f * Domain.x, 0f, 0f), Vector3.zero, 0u) }))
            {
                rig.Steps(2);
                Assert.That(rig.Particles()[0].IsRemoved, Is.False);
            }
        }

        [Test]
        public void MeasurementsAreOfTheLiquidAlone()
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var rig = new StandardRig(Settings(FluidFaces.LowY), Block()))
                using (var meter = new FluidStatisticsMeter(shaders, rig.Solver))
                {
                    while (rig.Solver.ReadCountersNow().Removed < 50) rig.Steps(10);
                    FluidParticle[] liquid = rig.Particles().Where(p => !p.IsRemoved).ToArray();
                    FluidStatistics statistics = meter.MeasureNow();
                    Assert.That(liquid.Length, Is.GreaterThan(0).And.LessThan(Block().Length));
                    Assert.That(statistics.ParticleCount, Is.EqualTo(liquid.Length));
                    Assert.That(statistics.Removed, Is.EqualTo(Block().Length - liquid.Length));
                    Assert.That(statistics.Listed, Is.EqualTo(liquid.Length));
                    Assert.That((statistics.Escaped, statistics.Misplaced, statistics.NonFinite), Is.EqualTo((0, 0, 0)));
                    Assert.That(statistics.MaxSpeed, Is.EqualTo(liquid.Max(p => p.VelT0.magnitude)).Within(1e-5));
                    Assert.That(statistics.KineticEnergy,
                        Is.EqualTo(0.5 * rig.Solver.Settings.ParticleMass * liquid.Sum(p => (double)p.VelT0.sqrMagnitude))
                            .Within(1e-4).Percent);
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }

        [Test]
        public void ClosedFacesHoldEverybody()
        {
            using (var rig = new StandardRig(Settings(FluidFaces.None), Block()))
            {
                rig.Steps(300);
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.Zero);
                Assert.That(rig.Particles().Any(p => p.IsRemoved), Is.False);
            }
        }

        [TestCase(FluidFaces.LowX, FluidAxes.None)]
        [TestCase(FluidFaces.HighX | FluidFaces.LowZ, FluidAxes.Y)]
        public void AnOpenFaceAddsNoDensityAndItsWallsDo(FluidFaces open, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(open, periodic);
            using (var rig = new StandardRig(settings, ParticleSets.Random(509, Domain, 0.1f, 6)))
            {
                rig.Setup();
                FluidParticle[] particles = rig.Particles();
                float[] density = rig.Densities();
                for (int i = 0; i < particles.Length; i++)
                {
                    Assert.That(density[i], Is.EqualTo(StandardReference.Density(particles, i, settings)).Within(2e-3).Percent,
                        $"particle {i}");
                }
            }
        }

        [Test]
        public void AFaceMayOpenWhileTheLiquidRuns()
        {
            using (var rig = new StandardRig(Settings(FluidFaces.None), Block()))
            {
                rig.Steps(100);
                rig.Solver.ApplySettings(Settings(FluidFaces.LowY));
                rig.Steps(200);
                long out1 = rig.Solver.ReadCountersNow().Removed;
                Assert.That(out1, Is.GreaterThan(0));
                rig.Solver.ApplySettings(Settings(FluidFaces.None));
                rig.Steps(100);
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.EqualTo(out1));
                rig.Solver.SetParticles(Block());
                rig.Steps(1);
                Assert.That(rig.Particles().Any(p => p.IsRemoved), Is.False, "others in their place are all liquid");
            }
        }

        [Test]
        public void WhatSlidesOffATriangleLeavesToo()
        {
            FluidSolverSettings settings = Settings(FluidFaces.LowY);
            using (var rig = new BodyRig(settings))
            {
                Transform plate = rig.AddBox(new Vector3(0.3f, 0.02f, 0.5f));
                plate.localPosition = new Vector3(0f, -0.25f, 0f);
                plate.localRotation = Quaternion.Euler(0f, 0f, 20f);
                FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 6, 5), Spacing, 0.02f * Spacing, 7);
                rig.Start(start);
                for (int turn = 0; turn < 6; turn++)
                {
                    rig.Frame(100);
                    FluidParticle[] particles = rig.Particles();
                    int live = particles.Count(p => !p.IsRemoved);
                    Assert.That(particles.Where(p => !p.IsRemoved).Select(p => p.Id), Is.Unique);
                    Assert.That(rig.Solver.ReadCountersNow().Removed, Is.EqualTo(start.Length - live));
                    Assert.That(particles.Where(p => !p.IsRemoved).All(p => IsInside(p.Position)));
                }
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.GreaterThan(start.Length / 2));
                Assert.That(rig.Solver.ReadCountersNow().Squeezed, Is.Zero);
            }
        }

        private static bool IsInside(Vector3 p) =>
            Mathf.Abs(p.x) <= 0.5f * Domain.x && Mathf.Abs(p.y) <= 0.5f * Domain.y && Mathf.Abs(p.z) <= 0.5f * Domain.z;

        private static long Listed(FluidSolver solver) =>
            GpuTest.Read<Vector2Int>(solver.GridIndices, solver.Grid.CellCount).Sum(range => (long)(range.y - range.x));
    }
}
