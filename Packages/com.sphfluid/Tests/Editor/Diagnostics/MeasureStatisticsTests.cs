using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>MeasureStatistics, its records added up, against brute force in double precision.</summary>
    public sealed class MeasureStatisticsTests
    {
        private const float Spacing = 0.04f;
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private FluidShaderSet shaders;

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
        public void SteppedLiquidAgreesWithBruteForceHalfAStepBack()
        {
            FluidSolverSettings settings = Settings(true, true);
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(257))))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 3, 0.5f * settings.TimeStep));
                FluidStatistics found = Measure(solver);
                FluidParticle[] moved = GpuTest.Read<FluidParticle>(solver.Particles, 257);
                AssertEqual(StatisticsReference.Measure(moved, settings, 0.25 * settings.TimeStep), found, settings);
            }
        }

        [Test]
        public void SameStateGivesTheSameBits()
        {
            using (var solver = new FluidSolver(Settings(true, true), shaders, Inside(Blob(1009))))
                Assert.That(Measure(solver), Is.EqualTo(Measure(solver)));
        }

        [Test]
        public void EachGroupWritesTheRecordOfItsOwnParticles([Values(1, 255, 256, 257, 1009)] int count)
        {
            const int canaries = 3;
            FluidSolverSettings settings = Settings(true, true);
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(count))))
            {
                Vector4[] records = Records(solver, canaries);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(solver.Particles, count);
                int groups = (count + 255) / 256;
                Assert.That(records.Length, Is.EqualTo(groups * FluidStatisticsRecord.Size + canaries));
                for (int group = 0; group < groups; group++)
                {
                    Double3 momentum = Double3.Zero;
                    double squares = 0.0, fastest = 0.0;
                    foreach (FluidParticle p in particles.Skip(256 * group).Take(256))
                    {
                        momentum += (Double3)p.VelT0;
                        squares += Double3.Dot(p.VelT0, p.VelT0);
                        fastest = Math.Max(fastest, ((Double3)p.VelT0).Length);
                    }

                    int first = group * FluidStatisticsRecord.Size;
                    Assert.That(records[first].w, Is.EqualTo(squares).Within(1e-3).Percent, $"squares of group {group}");
                    Assert.That(((Double3)(Vector3)records[first + 1] - momentum).Length, Is.LessThan(1e-4), $"momentum of group {group}");
                    Assert.That(records[first + 5].x, Is.EqualTo(fastest).Within(1e-3).Percent, $"speed of group {group}");
                }

                Assert.That(records.Skip(groups * FluidStatisticsRecord.Size), Is.All.EqualTo(Canary), "behind the last record");
            }
        }

        [Test]
        public void ParticlesMovedBehindTheGridsBackShow()
        {
            FluidSolverSettings settings = Settings(true, true);
            using (var solver = new FluidSolver(settings, shaders, Inside(Blob(257))))
            {
                Assert.That(Measure(solver).Misplaced, Is.Zero);
                FluidParticle[] moved = GpuTest.Read<FluidParticle>(solver.Particles, 257);
                for (int i = 0; i < moved.Length; i++) moved[i].Position = -moved[i].Position;
                solver.Particles.SetData(moved);
                Assert.That(Measure(solver).Misplaced, Is.GreaterThan(200));

                var ranges = new uint[2 * solver.Grid.CellCount];
                solver.GridIndices.GetData(ranges);
                int cell = 0;
                while (ranges[2 * cell + 1] > 0u) cell++;
                ranges[2 * cell + 1] = 7u; // an empty cell's range that was not cleared
                solver.GridIndices.SetData(ranges);
                Assert.That(Measure(solver).Listed, Is.EqualTo(257 + 7));
            }
        }

        private static readonly Vector4 Canary = new Vector4(-1f, -2f, -3f, -4f);

        private FluidStatistics Measure(FluidSolver solver)
        {
            Vector4[] records = Records(solver, 0);
            return FluidStatisticsRecord.Sum(records, records.Length / FluidStatisticsRecord.Size, new FluidMoment(solver, false));
        }

        private Vector4[] Records(FluidSolver solver, int behind)
        {
            var pass = new MeasureStatisticsPass(shaders);
            int length = pass.Groups(solver.ParticleCount) * FluidStatisticsRecord.Size + behind;
            using (GraphicsBuffer records = GpuBuffers.Create("Records", length, 16))
            {
                records.SetData(Enumerable.Repeat(Canary, length).ToArray());
                GpuTest.Run(cmd =>
                {
                    solver.RecordNeighbourSetup(cmd);
                    pass.Record(cmd, solver, records);
                });
                return GpuTest.Read<Vector4>(records, length);
            }
        }

        private FluidStatistics Check(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var solver = new FluidSolver(settings, shaders, Inside(particles)))
            {
                solver.Particles.SetData(particles); // sick ones pass no constructor
                FluidStatistics found = Measure(solver);
                FluidStatistics expected = StatisticsReference.Measure(particles, settings);
                AssertEqual(expected, found, settings);
                var ranges = new uint[2 * solver.Grid.CellCount];
                solver.GridIndices.GetData(ranges);
                int fullest = 0;
                for (int cell = 0; cell < solver.Grid.CellCount; cell++)
                {
                    fullest = Math.Max(fullest, (int)(ranges[2 * cell + 1] - ranges[2 * cell]));
                }
                Assert.That(found.MaxCellCount, Is.EqualTo(fullest).And.Positive);
                return found;
            }
        }

        private static void AssertEqual(FluidStatistics expected, FluidStatistics found, FluidSolverSettings settings)
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
            Assert.That(found.ElasticEnergy,
                Is.EqualTo(expected.ElasticEnergy).Within(0.01).Percent.Or.EqualTo(expected.ElasticEnergy).Within(1e-8 * energy),
                "elastic");
            Assert.That((found.Momentum - expected.Momentum).magnitude, Is.LessThan(1e-6 * Math.Max(1e-9, expected.MomentumScale)),
                "momentum");
            Assert.That(found.MomentumScale, Is.EqualTo(expected.MomentumScale).Within(1e-4).Percent, "momentum scale");
            Assert.That(found.MaxSpeed, Is.EqualTo(expected.MaxSpeed).Within(1e-4).Percent, "speed");
            Assert.That(found.MeanCompression, Is.EqualTo(expected.MeanCompression).Within(2e-5), "compression");
            Assert.That(found.MaxDensityRatio, Is.EqualTo(expected.MaxDensityRatio).Within(0.002).Percent, "largest density");
            Assert.That(found.MinDensityRatio, Is.EqualTo(expected.MinDensityRatio).Within(2e-5), "smallest density");
            Assert.That(found.Checkerboard, Is.EqualTo(expected.Checkerboard).Within(2e-5), "checkerboard");
        }

        private static FluidSolverSettings Settings(bool octant, bool clamp)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = octant;
            settings.PressureClamp = clamp;
            return settings;
        }

        // The lowest particles of a jittered lattice that fills the domain's lower half, with velocities.
        private static FluidParticle[] Blob(int count)
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

        private static FluidParticle[] Inside(FluidParticle[] particles)
        {
            var inside = new FluidParticle[particles.Length];
            for (int i = 0; i < inside.Length; i++) inside[i] = new FluidParticle(Vector3.zero, Vector3.zero, (uint)i);
            for (int i = 0; i < inside.Length; i++)
                if (Mathf.Abs(particles[i].Position.x) < 0.5f * Domain.x && Mathf.Abs(particles[i].Position.y) < 0.5f * Domain.y)
                {
                    inside[i] = particles[i];
                }
            return inside;
        }
    }
}
