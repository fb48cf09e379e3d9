using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>The GPU's statistics against brute force in double precision.</summary>
    public sealed class FluidStatisticsMeterTests
    {
        const float Spacing = 0.04f;
        static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256, false)]
        [TestCase(257)]
        [TestCase(1009)]
        [TestCase(1009, false, false)]
        public void StatisticsAgreeWithBruteForce(int count, bool octant = true, bool clamp = true)
        {
            FluidSolverSettings settings = Settings(octant, clamp);
            settings.BodyForce = new FluidBodyForce { Centre = new Vector3(0.1f, 0f, -0.2f), RateSquared = new Vector3(3f, 0f, 5f) };
            Check(settings, Blob(count));
        }

        [Test]
        public void SickParticlesAreCountedAndLeftOut([Values] bool octant)
        {
            FluidParticle[] particles = Blob(601);
            particles[10].Position = particles[11].Position;
            particles[300].Position = particles[301].Position + new Vector3(0.3f * Spacing, 0f, 0f);
            particles[20].Position.y = float.NaN;
            particles[21].VelT0.x = float.PositiveInfinity;
            particles[600].VelT0.z = float.NaN;
            particles[40].Position = new Vector3(0.5f * Domain.x + 0.6f * Spacing, 0f, 0f);
            particles[41].Position = new Vector3(0f, -0.5f * Domain.y - 0.4f * Spacing, 0f);
            particles[42].Position = new Vector3(0f, 0.5f * Domain.y - 0.05f * Spacing, 0.1f);
            FluidStatistics found = Check(Settings(octant, true), particles);
            Assert.That(found.NonFinite, Is.EqualTo(3));
            Assert.That(found.Escaped, Is.EqualTo(1));
            Assert.That(found.Coincident, Is.EqualTo(2));
            Assert.That(found.Clumped, Is.GreaterThanOrEqualTo(4));
            Assert.That(found.AtWalls, Is.GreaterThanOrEqualTo(3));
        }

        [TestCase(true)]
        [TestCase(false)]
        public void NeighboursAcrossPeriodicFacesCount(bool octant)
        {
            FluidSolverSettings settings = Settings(octant, false);
            settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Z;
            settings.Gravity = new Vector3(1f, -9f, 0.5f); // along x and z there is no potential
            FluidParticle[] particles = ParticleSets.Random(600, Domain, 1f, 12);
            particles[0].Position = new Vector3(0.5f * Domain.x - 0.1f * Spacing, 0f, 0f);
            particles[1].Position = new Vector3(-0.5f * Domain.x + 0.1f * Spacing, 0f, 0f);
            FluidStatistics found = Check(settings, particles);
            Assert.That(found.Clumped, Is.GreaterThanOrEqualTo(2));
        }

        [Test]
        public void ForcesWithoutSelfDensityLeaveLoneParticlesFinite()
        {
            FluidSolverSettings settings = Settings(true, false);
            settings = settings.WithOwn((ref ThesisSettings own) => own.SelfDensity = false);
            FluidStatistics found = Check(settings, Blob(31));
            Assert.That(found.MinDensityRatio, Is.Zero.Or.Positive);
        }

        [Test]
        public void EnergyOfAFallIsConstant()
        {
            FluidSolverSettings settings = Settings(true, true);
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
                double given = 0.5 * settings.ParticleMass * Math.Pow(9.81 * (fallen.Time - 0.5 * settings.TimeStep), 2);
                Assert.That(fallen.KineticEnergy - start.KineticEnergy, Is.EqualTo(given).Within(0.01).Percent);
                Assert.That(fallen.Energy - start.Energy, Is.Zero.Within(1e-4 * given));
            }
        }

        [Test]
        public void SteppedLiquidAgreesWithBruteForceHalfAStepBack()
        {
            FluidSolverSettings settings = Settings(true, true);
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(257))))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 3, 0.5f * settings.TimeStep));
                FluidStatistics found = meter.MeasureNow();
                FluidParticle[] moved = GpuTest.Read<FluidParticle>(solver.Particles, 257);
                AssertEqual(StatisticsReference.Measure(moved, settings, 0.25 * settings.TimeStep), found, settings);
            }
        }

        [Test]
        public void SameStateGivesTheSameBits()
        {
            using (var solver = new FluidSolver(Settings(true, true), shaders, Inside(Blob(1009))))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            using (var other = new FluidStatisticsMeter(shaders, solver))
                Assert.That(other.MeasureNow(), Is.EqualTo(meter.MeasureNow()));
        }

        [Test]
        public void AsynchronousMeasurementsArriveInOrderWithTheirTimes()
        {
            FluidSolverSettings settings = Settings(true, true);
            var arrived = new List<FluidStatistics>();
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(257))))
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
            using (var solver = new FluidSolver(Settings(true, true), shaders, Inside(Blob(31))))
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

        [Test]
        public void ParticlesMovedBehindTheGridsBackShow()
        {
            FluidSolverSettings settings = Settings(true, true);
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(257))))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                Assert.That(meter.MeasureNow().Misplaced, Is.Zero);
                FluidParticle[] moved = GpuTest.Read<FluidParticle>(solver.Particles, 257);
                for (int i = 0; i < moved.Length; i++) moved[i].Position = -moved[i].Position;
                solver.Particles.SetData(moved);
                Assert.That(meter.MeasureNow().Misplaced, Is.GreaterThan(200));

                var ranges = new uint[2 * solver.Grid.CellCount];
                solver.GridIndices.GetData(ranges);
                int cell = 0;
                while (ranges[2 * cell + 1] > 0u) cell++;
                ranges[2 * cell + 1] = 7u; // an empty cell's range that was not cleared
                solver.GridIndices.SetData(ranges);
                Assert.That(meter.MeasureNow().Listed, Is.EqualTo(257 + 7));
            }
        }

        FluidStatistics Check(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var solver = new FluidSolver(settings, shaders, Inside(particles)))
            using (var meter = new FluidStatisticsMeter(shaders, solver))
            {
                solver.Particles.SetData(particles); // sick ones pass no constructor
                FluidStatistics found = meter.MeasureNow();
                FluidStatistics expected = StatisticsReference.Measure(particles, settings);
                AssertEqual(expected, found, settings);
                var ranges = new uint[2 * solver.Grid.CellCount];
                solver.GridIndices.GetData(ranges);
                int fullest = 0;
                for (int cell = 0; cell < solver.Grid.CellCount; cell++) fullest = Math.Max(fullest, (int)(ranges[2 * cell + 1] - ranges[2 * cell]));
                Assert.That(found.MaxCellCount, Is.EqualTo(fullest).And.Positive);
                return found;
            }
        }

        static void AssertEqual(FluidStatistics expected, FluidStatistics found, FluidSolverSettings settings)
        {
            double counted = Math.Max(1, expected.ParticleCount - expected.NonFinite), energy = settings.ParticleMass * counted;
            Assert.That(found.ParticleCount, Is.EqualTo(expected.ParticleCount));
            Assert.That(found.NonFinite, Is.EqualTo(expected.NonFinite), "not finite");
            Assert.That(found.Escaped, Is.EqualTo(expected.Escaped), "escaped");
            Assert.That(found.Clumped, Is.EqualTo(expected.Clumped), "clumped");
            Assert.That(found.Coincident, Is.EqualTo(expected.Coincident), "coincident");
            Assert.That(found.MaxNeighbours, Is.EqualTo(expected.MaxNeighbours), "neighbours");
            Assert.That(found.Misplaced, Is.EqualTo(expected.Misplaced), "misplaced");
            Assert.That(found.Listed, Is.EqualTo(expected.Listed), "listed");
            Assert.That(found.AtWalls, Is.EqualTo(expected.AtWalls), "at walls");
            Assert.That(found.WallCrowding, Is.EqualTo(expected.WallCrowding).Within(1e-5), "wall crowding");
            Assert.That(found.KineticEnergy, Is.EqualTo(expected.KineticEnergy).Within(1e-5).Percent, "kinetic");
            Assert.That(found.PotentialEnergy, Is.EqualTo(expected.PotentialEnergy).Within(1e-6 * 9.81 * energy), "potential");
            Assert.That(found.ElasticEnergy, Is.EqualTo(expected.ElasticEnergy).Within(0.01).Percent.Or.EqualTo(expected.ElasticEnergy).Within(1e-8 * energy), "elastic");
            Assert.That((found.Momentum - expected.Momentum).magnitude, Is.LessThan(1e-6 * Math.Max(1e-9, expected.MomentumScale)), "momentum");
            Assert.That(found.MomentumScale, Is.EqualTo(expected.MomentumScale).Within(1e-4).Percent, "momentum scale");
            Assert.That(found.MaxSpeed, Is.EqualTo(expected.MaxSpeed).Within(1e-4).Percent, "speed");
            Assert.That(found.MeanCompression, Is.EqualTo(expected.MeanCompression).Within(2e-5), "compression");
            Assert.That(found.MaxDensityRatio, Is.EqualTo(expected.MaxDensityRatio).Within(0.002).Percent, "largest density");
            Assert.That(found.MinDensityRatio, Is.EqualTo(expected.MinDensityRatio).Within(2e-5), "smallest density");
            Assert.That(found.Checkerboard, Is.EqualTo(expected.Checkerboard).Within(2e-5), "checkerboard");
        }

        static FluidSolverSettings Settings(bool octant, bool clamp)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = octant;
            settings.PressureClamp = clamp;
            return settings;
        }

        // The lowest particles of a jittered lattice that fills the domain's lower half, with velocities.
        static FluidParticle[] Blob(int count)
        {
            FluidParticle[] lattice = ParticleSets.Lattice(new Vector3Int(15, 6, 13), 0.97f * Spacing, 0.1f * Spacing, 5);
            var random = new System.Random(count);
            var particles = new FluidParticle[count];
            for (int i = 0; i < count; i++)
            {
                Vector3 position = lattice[i * 7 % lattice.Length].Position + new Vector3(0f, -0.11f, 0f);
                particles[i] = new FluidParticle(position, ParticleSets.RandomVector(random), (uint)i);
            }
            return particles;
        }

        static FluidParticle[] Inside(FluidParticle[] particles)
        {
            var inside = new FluidParticle[particles.Length];
            for (int i = 0; i < inside.Length; i++) inside[i] = new FluidParticle(Vector3.zero, Vector3.zero, (uint)i);
            for (int i = 0; i < inside.Length; i++)
                if (Mathf.Abs(particles[i].Position.x) < 0.5f * Domain.x && Mathf.Abs(particles[i].Position.y) < 0.5f * Domain.y) inside[i] = particles[i];
            return inside;
        }
    }
}
