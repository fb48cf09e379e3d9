using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Steps of changing length: leapfrog stays exact for a fall, and equal steps are what they were.</summary>
    public sealed class ChangingStepTests
    {
        private static readonly Vector3 Domain = new Vector3(8f, 8f, 8f);
        private static readonly float[] Lengths = { 1f / 512f, 1f / 256f, 1f / 256f, 1f / 2048f, 3f / 1024f, 1f / 512f };

        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void AFallIsTheExactParabola([Values(1, 7)] int stepsOfALength)
        {
            FluidSolverSettings settings = Settings();
            FluidParticle[] start = Scattered();
            using (var solver = new FluidSolver(settings, shaders, start))
            {
                double time = 0.0;
                foreach (float length in Lengths)
                {
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, stepsOfALength, length));
                    double last = time + (stepsOfALength - 1) * (double)length;
                    time += stepsOfALength * (double)length;
                    foreach (FluidParticle p in GpuTest.Read<FluidParticle>(solver.Particles, start.Length))
                    {
                        FluidParticle first = start[p.Id];
                        Double3 x = (Double3)first.Position + time * (Double3)first.VelT0 + 0.5 * time * time * (Double3)settings.Gravity;
                        Double3 vHalf = (Double3)first.VelT0 + (time - 0.5 * length) * (Double3)settings.Gravity;
                        Double3 vLast = (Double3)first.VelT0 + last * (Double3)settings.Gravity;
                        Assert.That(((Double3)p.Position - x).Length, Is.LessThan(3e-6), $"position at {time} s");
                        Assert.That(((Double3)p.VelT0 - vHalf).Length, Is.LessThan(3e-6), "velocity half a step before");
                        Assert.That(((Double3)p.VelT1 - vLast).Length, Is.LessThan(3e-6), "velocity at the last force");
                    }
                }

                Assert.That(solver.SimulatedTime, Is.EqualTo(time).Within(1e-12));
                Assert.That(solver.StepCount, Is.EqualTo(Lengths.Length * stepsOfALength));
            }
        }

        [Test]
        public void TheSettingsLengthByHandGivesTheSameBits()
        {
            FluidSolverSettings settings = TestSettings.ByRule(0.4f * Vector3.one, 0.02f);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(7, 6, 7), 0.018f, 1e-3f, 2);
            FluidParticle[] byHand = Run(settings, start, (solver, i, cmd) => solver.RecordSteps(cmd, 1, settings.TimeStep));
            Assert.That(byHand, Is.EqualTo(Run(settings, start, (solver, i, cmd) => solver.RecordSteps(cmd, 1))));
        }

        // One spacing a step: at half the length four times the acceleration, as printed the same.
        [TestCase(ThesisAccelerationLimit.Emergency, 4f)]
        [TestCase(ThesisAccelerationLimit.AsPrinted, 1f)]
        public void TheAccelerationLimitGoesWithTheStep(ThesisAccelerationLimit limit, float factor)
        {
            ThesisSwitches switches = ThesisSwitches.Corrected;
            switches.AccelerationLimit = limit;
            FluidSolverSettings settings = TestSettings.ByRule(0.4f * Vector3.one, 0.02f).With(switches);
            settings.Gravity = Vector3.zero;
            settings.RestDensity = 1f;
            FluidParticle[] pair = { new FluidParticle(Vector3.zero, Vector3.zero, 0),
                new FluidParticle(new Vector3(1e-3f, 0f, 0f), Vector3.zero, 1) };
            float[] speeds = new[] { 1f, 0.5f }.Select(part => Run(settings, pair,
                (solver, i, cmd) => solver.RecordSteps(cmd, i == 0 ? 1 : 0, part * settings.TimeStep))[0].VelT0.magnitude).ToArray();
            float full = 0.5f * settings.Own<ThesisSettings>().AccelerationLimit * settings.TimeStep; // the first step gives half a kick
            Assert.That(speeds[0], Is.EqualTo(full).Within(1e-4f * full), "limited");
            Assert.That(speeds[1], Is.EqualTo(0.5f * factor * full).Within(1e-4f * full));
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void ALengthThatIsNoneIsRefused(float length)
        {
            using (var solver = new FluidSolver(Settings(), shaders, Scattered()))
            {
                Assert.That(() => GpuTest.Run(cmd => solver.RecordSteps(cmd, 1, length)),
                    Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("positive"));
            }
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.1f);
            settings.Gravity = new Vector3(0.5f, -9.75f, 2.25f);
            return settings;
        }

        private static FluidParticle[] Scattered()
        {
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(3, 3, 3), 0.3f, 0.01f, 1);
            for (int i = 0; i < start.Length; i++) start[i].VelT0 = start[i].VelT1 = new Vector3(0.25f, 1f, -0.5f);

            return start;
        }

        private FluidParticle[] Run(in FluidSolverSettings settings, FluidParticle[] start,
            Action<FluidSolver, int, UnityEngine.Rendering.CommandBuffer> record)
        {
            using (var solver = new FluidSolver(settings, shaders, start))
            {
                for (int i = 0; i < 20; i++) GpuTest.Run(cmd => record(solver, i, cmd));

                return GpuTest.Read<FluidParticle>(solver.Particles, start.Length);
            }
        }
    }
}
