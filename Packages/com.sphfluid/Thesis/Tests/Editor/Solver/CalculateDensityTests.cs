using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.3.1 against double precision.</summary>
    public sealed class CalculateDensityTests
    {
        // A term (h² − r²)³ is off by about 3 h⁴ · 4e-7 h² in float; the ~30 terms of a neighbourhood add to 1e-5 of the density.
        private const double Tolerance = 1e-5;

        private static readonly Vector3 Domain = new Vector3(0.3f, 0.2f, 0.25f);

        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        [TestCase(2003)]
        public void AgreesWithDoublePrecision(int count)
        {
            Check(TestSettings.ByRule(Domain, 0.02f), count);
        }

        [TestCase(false, true, true)]
        [TestCase(true, false, true)]
        [TestCase(true, true, false)]
        public void SwitchesAct(bool self, bool clamp, bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            settings = settings.WithOwn((ref ThesisSettings own) => own.SelfDensity = self);
            settings.PressureClamp = clamp;
            settings.OctantSearch = octant;
            Check(settings, 509);
        }

        [Test]
        public void NoParticlesRecordNothing()
        {
            using (var rig = new ThesisRig(TestSettings.ByRule(Domain, 0.02f), new FluidParticle[0]))
            {
                Assert.DoesNotThrow(rig.RunNeighbourSetup);
            }
        }

        [Test]
        public void RestLatticeHasTheRestDensity()
        {
            const float spacing = 0.02f;
            FluidParticle[] lattice = ParticleSets.Lattice(new Vector3Int(9, 9, 9), spacing, 0f, 1);
            using (var rig = new ThesisRig(TestSettings.ByRule(Domain, spacing), lattice))
            {
                rig.RunNeighbourSetup();
                FluidParticle[] particles = rig.ReadParticles();
                float[] density = rig.ReadDensity();
                int middle = Array.FindIndex(particles, p => p.Position.magnitude < 0.1f * spacing);
                Assert.That(density[middle], Is.EqualTo(1000.0).Within(Tolerance * 1000.0));
            }
        }

        private static void Check(in FluidSolverSettings settings, int count)
        {
            using (var rig = new ThesisRig(settings, ParticleSets.Random(count, Domain, 1f, count)))
            {
                rig.RunNeighbourSetup();
                FluidParticle[] particles = rig.ReadParticles();
                float[] density = rig.ReadDensity();
                float[] pressure = rig.ReadPressure();
                for (int i = 0; i < count; i++)
                {
                    double expected = ThesisReference.Density(particles, i, settings);
                    double scale = Tolerance * Math.Max(expected, settings.RestDensity);
                    Assert.That(density[i], Is.EqualTo(expected).Within(scale), $"density of {i} of {count}");
                    Assert.That(pressure[i],
                        Is.EqualTo(ThesisReference.Pressure(expected, settings)).Within(settings.Own<ThesisSettings>().Stiffness * scale),
                        $"pressure of {i} of {count}");
                }
            }
        }
    }
}
