using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.3.2 against double precision, on the densities and pressures that the GPU found.</summary>
    public sealed class CalculateForceTests
    {
        // Each term is off by some float roundings of distance and direction; h − r loses digits where r is near h.
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
            Check(TestSettings.ByRule(Domain, 0.02f), ParticleSets.Random(count, 0.5f * Domain, 3f, count));
        }

        [TestCase(true, 0f)]
        [TestCase(false, 0f)]
        [TestCase(false, 5f)]
        public void HalfAndViscosityAct(bool half, float viscosity)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            settings = settings.WithOwn((ref ThesisSettings own) => own.PressureHalf = half);
            settings.Viscosity = viscosity;
            Check(settings, ParticleSets.Random(509, 0.5f * Domain, 3f, 4));
        }

        [Test]
        public void CoincidentParticlesPartByTheirNumbers()
        {
            FluidParticle[] particles = ParticleSets.Random(40, 0.02f * Vector3.one, 0f, 5);
            particles[1].Position = particles[0].Position;
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            Check(settings, particles);
        }

        private static void Check(in FluidSolverSettings settings, FluidParticle[] initial)
        {
            using (var rig = new ThesisRig(settings, initial))
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
                    Double3 expected = ThesisReference.Force(particles, density, pressure, i, settings, out double magnitude);
                    Double3 actual = (Vector3)force[i];
                    Assert.That((actual - expected).Length, Is.LessThanOrEqualTo(Tolerance * magnitude),
                        $"particle {i} of {particles.Length}: {actual}, expected {expected}");
                }
            }
        }
    }
}
