using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Measurements over time and how they arrive; their figures: MeasureStatisticsTests.</summary>
    public sealed class FluidStatisticsMeterTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private readonly FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void EnergyOfAFallIsConstant()
        {
            var lone = new[] { new FluidParticle(new Vector3(0f, 0.2f, 0f), new Vector3(0.3f, 0f, 0f), 0) };
            using (var solver = new FluidSolver(settings, shaders, lone))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                FluidStatistics start = meter.MeasureNow();
                int steps = (int)(0.2 / settings.TimeStep);
                GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                FluidStatistics fallen = meter.MeasureNow();
                Assert.That(fallen.Step, Is.EqualTo(steps));
                Assert.That(fallen.Time, Is.EqualTo(solver.SimulatedTime));
                double speed = 9.81 * (fallen.Time - 0.5 * settings.TimeStep);
                double given = 0.5 * settings.ParticleMass * speed * speed;
                Assert.That(fallen.KineticEnergy - start.KineticEnergy, Is.EqualTo(given).Within(0.01).Percent);
                Assert.That(fallen.Energy - start.Energy, Is.Zero.Within(1e-4 * given));
            }
        }

        [Test]
        public void AsynchronousMeasurementsArriveInOrderWithTheirTimes()
        {
            var arrived = new List<FluidStatistics>();
            using (var solver = new FluidSolver(settings, shaders, ParticleSets.Random(257, Domain, 1f, 1)))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                meter.Measured += arrived.Add;
                var expected = new List<FluidStatistics>();
                for (int i = 0; i < 3; i++)
                {
                    GpuTest.Run(cmd =>
                    {
                        solver.RecordSteps(cmd, i);
                        meter.Record(cmd);
                    });
                    expected.Add(meter.MeasureNow());
                }
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(arrived, Is.EqualTo(expected));
            }
        }

        [Test]
        public void DisposedMeterDropsWhatIsUnderWay()
        {
            int arrived = 0;
            using (var solver = new FluidSolver(settings, shaders, ParticleSets.Random(31, Domain, 1f, 1)))
            {
                var meter = new FluidStatisticsMeter(shaders, solver);
                meter.Measured += _ => arrived++;
                GpuTest.Run(meter.Record);
                meter.Dispose();
                meter.Dispose();
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(arrived, Is.Zero);
                Assert.That(() => meter.MeasureNow(), Throws.TypeOf<ObjectDisposedException>());
            }
        }
    }
}
