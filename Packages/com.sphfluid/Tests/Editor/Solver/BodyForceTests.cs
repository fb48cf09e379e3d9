using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The force by position, a = −ω² (x − centre), and what it does to single particles.</summary>
    public sealed class BodyForceTests
    {
        private static readonly Vector3 Domain = new Vector3(4f, 3f, 5f);
        private static readonly Vector3 Rate = new Vector3(9f, 2.5f, -4f);
        private static readonly Vector3 Centre = new Vector3(0.1f, -0.2f, 0.3f);

        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        public void AccelerationIsTheDistanceTimesTheRate(int count)
        {
            FluidSolverSettings settings = Settings();
            settings.Gravity = new Vector3(0.5f, -9f, 0.25f);
            using (var rig = new ThesisRig(settings, ParticleSets.Random(count, 0.9f * Domain, 1f, count)))
            {
                rig.State.Published.Density.SetData(Filled(count, 1000f));
                rig.State.Buffers.Force.SetData(new Vector4[count]);
                var pass = new CalculateAccelerationPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, rig.Step));
                FluidParticle[] particles = rig.ReadParticles();
                Vector4[] acceleration = rig.ReadAcceleration();
                for (int i = 0; i < count; i++)
                {
                    Vector3 p = particles[i].Position;
                    var expected = new Double3(0.5 - 9.0 * (p.x - 0.1f), -9.0 - 2.5 * (p.y + 0.2f), 0.25 + 4.0 * (p.z - 0.3f));
                    Assert.That(((Double3)(Vector3)acceleration[i] - expected).Length, Is.LessThan(1e-5), $"particle {i} at {p}");
                }
            }
        }

        // x = A cos ω t, 5 m/s² at most; the leapfrog's frequency errs by (ω dt)²/24, a part in 10^6.
        [Test]
        public void AParticleSwingsAboutTheCentre()
        {
            FluidSolverSettings settings = Settings();
            settings.TimeStep = 1f / 512f;
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                var start = new FluidParticle(Centre + new Vector3(0.5f, 0f, 0f), Vector3.zero, 0);
                using (var solver = new FluidSolver(settings, shaders, new[] { start }))
                {
                    for (int batch = 1; batch <= 3; batch++)
                    {
                        GpuTest.Run(cmd => solver.RecordSteps(cmd, 55));
                        FluidParticle p = GpuTest.Read<FluidParticle>(solver.Particles, 1)[0];
                        Assert.That(p.Position.x - Centre.x, Is.EqualTo(0.5 * Math.Cos(3.0 * solver.SimulatedTime)).Within(2e-5));
                        Assert.That(p.Position.y, Is.EqualTo(Centre.y).Within(1e-6));
                    }
                }
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(shaders);
            }
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.05f);
            settings.Gravity = Vector3.zero;
            settings.BodyForce = new FluidBodyForce { Centre = Centre, RateSquared = Rate };
            return settings;
        }

        private static float[] Filled(int count, float value)
        {
            var array = new float[count];
            Array.Fill(array, value);
            return array;
        }
    }
}
