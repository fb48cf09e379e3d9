using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.3.4 against the closed form of a uniformly accelerated motion.</summary>
    public sealed class CalculateNewPositionTests
    {
        private const int Steps = 100;
        private const float TimeStep = 1f / 512f;

        private static readonly Vector3 Acceleration = new Vector3(0.5f, -9.75f, 2.25f);

        [TestCase(1)]
        [TestCase(257)]
        [TestCase(1009)]
        public void HalfKickGivesTheExactParabola(int count)
        {
            FluidParticle[] start = Start(count);
            FluidParticle[] end = Integrate(start, true);
            double t = Steps * (double)TimeStep;
            for (int i = 0; i < count; i++)
            {
                Double3 x = (Double3)start[i].Position + t * (Double3)start[i].VelT0 + 0.5 * t * t * (Double3)Acceleration;
                Double3 vHalf = (Double3)start[i].VelT0 + (t - 0.5 * TimeStep) * (Double3)Acceleration;
                Double3 vLast = (Double3)start[i].VelT0 + (t - TimeStep) * (Double3)Acceleration;

                // A hundred additions of float, each rounded to 2^-24 of about 1 m and 3 m/s.
                Assert.That(((Double3)end[i].Position - x).Length, Is.LessThan(2e-5), "position at t");
                Assert.That(((Double3)end[i].VelT0 - vHalf).Length, Is.LessThan(5e-5), "VelT0 at t - dt/2");
                Assert.That(((Double3)end[i].VelT1 - vLast).Length, Is.LessThan(5e-5), "VelT1 at t - dt");
            }
        }

        [Test]
        public void WithoutHalfKickAFallIsHalfAStepAhead()
        {
            FluidParticle[] start = Start(1);
            double t = Steps * (double)TimeStep;
            Double3 lead = (Double3)Integrate(start, false)[0].Position - Integrate(start, true)[0].Position;
            Assert.That((lead - 0.5 * t * TimeStep * (Double3)Acceleration).Length, Is.LessThan(2e-5));
        }

        [Test]
        public void LeavingTheDomainIsStoppedAndCounted()
        {
            FluidSolverSettings settings = TestSettings.ByRule(2f * Vector3.one, 0.05f);
            var outwards = new FluidParticle(new Vector3(0.99f, 0.2f, 0f), new Vector3(100f, 1f, 0f), 0);
            using (var rig = new ThesisRig(settings, new[] { outwards }))
            {
                Step(rig, Vector4.zero, 1);
                FluidParticle end = rig.ReadParticles()[0];
                Assert.That(end.Position.x, Is.EqualTo(1f));
                Assert.That(end.VelT0, Is.EqualTo(new Vector3(0f, 1f, 0f)));
                Assert.That(GpuTest.Read<uint>(rig.State.Published.Counters, 8)[1], Is.EqualTo(1u));
            }
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void ANumberThatIsNoneIsStoppedAndCounted(float bad)
        {
            FluidSolverSettings settings = TestSettings.ByRule(2f * Vector3.one, 0.05f);
            using (var rig = new ThesisRig(settings, Start(3)))
            {
                Step(rig, new Vector4(0f, bad, 0f, 0f), 1);
                Assert.That(rig.ReadParticles().Select(p => p.Position), Is.EqualTo(Start(3).Select(p => p.Position)));
                Assert.That(GpuTest.Read<uint>(rig.State.Published.Counters, 8)[2], Is.EqualTo(3u));
            }
        }

        private static FluidParticle[] Start(int count) => ParticleSets.Random(count, 0.5f * Vector3.one, 1f, count);

        private static FluidParticle[] Integrate(FluidParticle[] start, bool halfKick)
        {
            FluidSolverSettings settings = TestSettings.ByRule(8f * Vector3.one, 0.1f);
            settings.TimeStep = TimeStep;
            settings = settings.WithOwn((ref ThesisSettings own) => own.HalfKick = halfKick);
            using (var rig = new ThesisRig(settings, start))
            {
                Step(rig, Acceleration, Steps);
                return rig.ReadParticles();
            }
        }

        private static void Step(ThesisRig rig, Vector4 acceleration, int steps)
        {
            rig.State.Published.Counters.SetData(new uint[CounterReadback.Slots]);
            rig.State.Buffers.Acceleration.SetData(Enumerable.Repeat(acceleration, rig.State.ParticleCount).ToArray());
            var pass = new CalculateNewPositionPass(rig.Shaders);
            GpuTest.Run(cmd =>
            {
                for (int i = 0; i < steps; i++)
                {
                    pass.Record(cmd, rig.State, new FluidStep(rig.State.Settings.TimeStep, rig.State.Settings.TimeStep, i == 0));
                }
            });
        }
    }
}
