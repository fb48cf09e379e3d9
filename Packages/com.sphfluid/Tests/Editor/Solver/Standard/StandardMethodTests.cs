using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class StandardMethodTests
    {
        private const float Spacing = 0.05f;

        private static FluidSolverSettings Settings(Vector3 domain, FluidAxes periodic = FluidAxes.None)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = domain;
            input.Spacing = Spacing;
            input.SupportRatio = 2f;
            input.LiquidHeight = domain.y;
            input.LiquidDepth = 0.5f * domain.y;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        [TestCase(1, FluidAxes.None)]
        [TestCase(63, FluidAxes.None)]
        [TestCase(64, FluidAxes.X)]
        [TestCase(65, FluidAxes.None)]
        [TestCase(257, FluidAxes.All)]
        [TestCase(1009, FluidAxes.None)]
        [TestCase(1009, FluidAxes.X | FluidAxes.Z)]
        public void DensityIsTheSumOverAllPairs(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(new Vector3(0.4f, 0.5f, 0.3f), periodic);
            using (StandardRig rig = new StandardRig(settings, ParticleSets.Random(count, settings.DomainSize, 1f, 3)))
            {
                rig.Setup();
                FluidParticle[] particles = rig.Particles();
                float[] density = rig.Densities();
                Assert.That(particles.Select(p => p.Id).Distinct().Count(), Is.EqualTo(count));
                for (int i = 0; i < count; i++)
                {
                    Assert.That(density[i], Is.EqualTo(StandardReference.Density(particles, i, settings)).Within(2e-3).Percent,
                        $"particle {i}");
                }
            }
        }

        [TestCase(65, FluidAxes.None)]
        [TestCase(257, FluidAxes.All)]
        [TestCase(509, FluidAxes.Y)]
        public void OneStepIsTheSumOfAllForces(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(new Vector3(0.4f, 0.5f, 0.3f), periodic);
            FluidParticle[] start = ParticleSets.Random(count, 0.8f * settings.DomainSize, 0.1f, 4);
            settings.TimeStep = 1e-5f;
            using (StandardRig rig = new StandardRig(settings, start))
            {
                double[] density = Enumerable.Range(0, count).Select(i => StandardReference.Density(start, i, settings)).ToArray();
                rig.Steps(1);
                FluidParticle[] after = rig.Particles().OrderBy(p => p.Id).ToArray();
                double largest = 0.0;
                for (int i = 0; i < count; i++)
                {
                    Double3 expected = StandardReference.Acceleration(start, density, i, settings);
                    largest = Math.Max(largest, expected.Length);
                }
                for (int i = 0; i < count; i++)
                {
                    Double3 expected = StandardReference.Acceleration(start, density, i, settings);
                    Double3 measured = 2.0 / settings.TimeStep * ((Double3)after[i].VelT0 - start[i].VelT0);
                    Assert.That((measured - expected).Length, Is.LessThan(2e-4 * largest + 0.02),
                        $"particle {i}: {measured} for {expected}");
                }
            }
        }

        [Test]
        public void ALatticeFromWallToWallHasTheRestDensity()
        {
            FluidSolverSettings settings = Settings(8 * Spacing * Vector3.one);
            using (StandardRig rig = new StandardRig(settings, ParticleSets.Lattice(8 * Vector3Int.one, Spacing, 0f, 1)))
            {
                rig.Setup();
                foreach (float density in rig.Densities()) Assert.That(density, Is.EqualTo(settings.RestDensity).Within(1).Percent);
            }
        }

        [Test]
        public void DensityFollowsTheCompressionOfALattice()
        {
            // 0.2 % nearer along each axis: 0.6 % denser, while the plain sum gains but 0.57 % at κ = 2.
            const float Scale = 0.998f;
            FluidSolverSettings settings = Settings(8 * Scale * Spacing * Vector3.one, FluidAxes.All);
            using (StandardRig rig = new StandardRig(settings, ParticleSets.Lattice(8 * Vector3Int.one, Scale * Spacing, 0f, 1)))
            {
                rig.Setup();
                double gained = rig.Densities().Average() / settings.RestDensity - 1;
                Assert.That(gained, Is.EqualTo(Math.Pow(Scale, -3) - 1).Within(1.5).Percent);
            }
        }

        [Test]
        public void EqualRunsAreEqualToTheLastBit()
        {
            FluidSolverSettings settings = Settings(new Vector3(0.4f, 0.5f, 0.3f));
            FluidParticle[] Run()
            {
                using (StandardRig rig =
                    new StandardRig(settings, ParticleSets.Lattice(new Vector3Int(7, 8, 5), Spacing, 0.2f * Spacing, 1)))
                {
                    rig.Steps(40);
                    return rig.Particles();
                }
            }
            FluidParticle[] first = Run(), second = Run();
            Assert.That(second, Is.EqualTo(first));
            Assert.That(first.Max(p => p.VelT0.magnitude), Is.GreaterThan(0.1f));
        }

        [Test]
        public void TwoParticlesInOnePlacePart()
        {
            FluidSolverSettings settings = Settings(Vector3.one);
            var start = ParticleSets.Lattice(4 * Vector3Int.one, Spacing, 0f, 1)
                .Concat(new[] { new FluidParticle(0.5f * Spacing * Vector3.one, Vector3.zero, 64u) }).ToArray();
            settings.Gravity = Vector3.zero;
            using (StandardRig rig = new StandardRig(settings, start))
            {
                rig.Steps(400);
                FluidParticle[] after = rig.Particles();
                Assert.That(rig.Solver.ReadCountersNow().NonFinite, Is.Zero);
                float nearest = (from a in after from b in after where a.Id < b.Id select (a.Position - b.Position).magnitude).Min();
                Assert.That(nearest, Is.GreaterThan(0.15f * Spacing));
            }
        }

        [TestCase(4f, 10)]
        [TestCase(19f, 2048)]
        public void ManyCellsFillManyScanGroups(float size, int groups)
        {
            FluidSolverSettings settings = Settings(size * Vector3.one);
            using (new ForcedCells(false))
            using (StandardRig rig = new StandardRig(settings, ParticleSets.Random(5003, settings.DomainSize, 1f, 9)))
            {
                Assert.That(rig.Solver.CellCount, Is.GreaterThan(groups * CellRows.CellsPerScanGroup));
                rig.Setup();
                FluidParticle[] particles = rig.Particles();
                Assert.That(particles.Select(p => p.Id).OrderBy(id => id), Is.EqualTo(Enumerable.Range(0, 5003).Select(i => (uint)i)));
                float[] density = rig.Densities();
                for (int i = 0; i < particles.Length; i += 41)
                {
                    Assert.That(density[i], Is.EqualTo(StandardReference.Density(particles, i, settings)).Within(2e-3).Percent);
                }
            }
        }
    }
}
