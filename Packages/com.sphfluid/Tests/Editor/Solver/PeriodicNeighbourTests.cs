using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The neighbour loop across periodic faces: every pair of nearest images within h, once, from both sides.</summary>
    public sealed class PeriodicNeighbourTests
    {
        // R = 0.05 m: 4 cells of 2R and 9 of R along x, with some to spare.
        private static readonly Vector3 Domain = new Vector3(0.47f, 0.41f, 0.53f);

        [TestCase(1, true, FluidAxes.All)]
        [TestCase(255, true, FluidAxes.All)]
        [TestCase(256, false, FluidAxes.All)]
        [TestCase(257, true, FluidAxes.X)]
        [TestCase(257, false, FluidAxes.X)]
        [TestCase(1009, true, FluidAxes.Y | FluidAxes.Z)]
        [TestCase(1009, false, FluidAxes.Y | FluidAxes.Z)]
        [TestCase(2003, true, FluidAxes.All)]
        [TestCase(2003, false, FluidAxes.All)]
        public void PairsAgreeWithBruteForce(int count, bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = Settings(Domain, octant, periodic);
            Check(settings, ParticleSets.Random(count, Domain, 0f, count));
        }

        [Test]
        public void BoxesOfTheLeastSizeVisitNoPairTwice([Values] bool octant,
            [Values(FluidAxes.X, FluidAxes.Z, FluidAxes.All)] FluidAxes periodic)
        {
            float side = octant ? 0.2f : 0.15f; // 2 cells of 2R, 3 of R
            FluidSolverSettings settings = Settings(side * Vector3.one, octant, periodic);
            Assert.That(FluidGrid.For(settings).Counts[periodic == FluidAxes.Z ? 2 : 0], Is.EqualTo(octant ? 2 : 3));
            Check(settings, ParticleSets.Random(509, settings.DomainSize, 0f, 6));
        }

        [Test]
        public void ParticlesOnAndNextToTheFacesAgreeWithBruteForce([Values] bool octant)
        {
            // Every combination of on a face, a rounding inside it, half a reach inside, and the middle, along the three axes.
            FluidSolverSettings settings = Settings(Domain, octant, FluidAxes.All);
            float[] places = { -0.5f, -0.49999997f, -0.45f, 0f, 0.45f, 0.49999997f, 0.5f };
            FluidParticle[] particles = Enumerable.Range(0, 343).Select(i => new FluidParticle(
                Vector3.Scale(Domain, new Vector3(places[i % 7], places[i / 7 % 7], places[i / 49])), Vector3.zero, (uint)i)).ToArray();
            Check(settings, particles);
        }

        [Test]
        public void DensityAndForceAgreeWithDoublePrecision([Values] bool octant)
        {
            FluidSolverSettings settings = Settings(Domain, octant, FluidAxes.X | FluidAxes.Z);
            using (var rig = new ThesisRig(settings, ParticleSets.Random(1009, Domain, 3f, 7)))
            {
                rig.RunNeighbourSetup();
                var pass = new CalculateForcePass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                FluidParticle[] particles = rig.ReadParticles();
                float[] density = rig.ReadDensity();
                float[] pressure = rig.ReadPressure();
                Vector4[] force = rig.ReadForce();
                for (int i = 0; i < particles.Length; i++)
                {
                    double expected = ThesisReference.Density(particles, i, settings);
                    Assert.That(density[i], Is.EqualTo(expected).Within(1e-5 * expected), $"density of {i}");
                    Double3 forceExpected = ThesisReference.Force(particles, density, pressure, i, settings, out double magnitude);
                    Assert.That(((Double3)(Vector3)force[i] - forceExpected).Length, Is.LessThanOrEqualTo(2e-5 * magnitude),
                        $"force on {i}");
                }
            }
        }

        [Test]
        public void ALatticeThatFillsThePeriodicBoxHasNoSurface([Values] bool octant)
        {
            var counts = new Vector3Int(9, 8, 11);
            const float spacing = 0.025f;
            FluidSolverSettings settings = Settings(spacing * (Vector3)counts, octant, FluidAxes.All);
            using (var rig = new ThesisRig(settings, ParticleSets.Lattice(counts, spacing, 0f, 1)))
            {
                rig.RunNeighbourSetup();
                Assert.That(rig.ReadDensity(), Is.All.EqualTo(settings.RestDensity).Within(0.05f));
            }
        }

        private static FluidSolverSettings Settings(Vector3 domain, bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(domain, 0.025f);
            settings.OctantSearch = octant;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        private static void Check(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var rig = new ThesisRig(settings, particles))
            {
                rig.RunNeighbourSetup();
                NeighbourPairs.Check(rig);
            }
        }
    }
}
