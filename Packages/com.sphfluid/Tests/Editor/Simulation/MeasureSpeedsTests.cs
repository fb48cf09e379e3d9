using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>MeasureSpeeds against counts in double precision.</summary>
    public sealed class MeasureSpeedsTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(1)]
        [TestCase(63)]
        [TestCase(64)]
        [TestCase(65)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        public void EverySpeedAndHeadIsInItsBin(int count)
        {
            FluidSolverSettings settings = Settings();
            settings.BodyForce = new FluidBodyForce { Centre = new Vector3(0.1f, 0f, -0.2f), RateSquared = new Vector3(3f, 0f, -5f) };
            FluidParticle[] particles = Spread(count);
            double lowest = LowestByLattice(settings);
            uint[] counts = Measure(settings, particles);
            AssertCounts(counts, SpeedCounts.Speeds, particles.Select(p => Square(p.VelT0)).ToArray());
            AssertCounts(counts, SpeedCounts.Heads,
                particles.Select(p => Square(p.VelT0) + 2.0 * (Potential(settings, p.Position) - lowest)).ToArray());
            Assert.That(counts.Skip(SpeedCounts.Distances).Take(SpeedCounts.Bins), Is.All.Zero, "no places were kept");
        }

        [Test]
        public void ParticlesThatLeftTheDomainAreNotCounted([Values(0, 1, 64, 601)] int left)
        {
            FluidParticle[] particles = Spread(601);
            for (int i = 0; i < left; i++) particles[(i * 7) % 601].Removed = 1f;
            uint[] counts = Measure(Settings(), particles);
            FluidParticle[] rest = particles.Where(p => !p.IsRemoved).ToArray();
            AssertCounts(counts, SpeedCounts.Speeds, rest.Select(p => Square(p.VelT0)).ToArray());
            if (left == 601) Assert.That(SpeedCounts.Quantile(counts, SpeedCounts.Speeds, 0.99), Is.Zero);
        }

        [Test]
        public void SpeedsThatAreNoNumbersAreInTheLastBin()
        {
            FluidParticle[] particles = Spread(65);
            particles[3].VelT0 = new Vector3(float.NaN, 0f, 0f);
            particles[30].VelT0 = new Vector3(0f, float.PositiveInfinity, 0f);
            particles[31].VelT0 = new Vector3(0f, -1e25f, 0f);
            particles[64].VelT0 = Vector3.zero;
            uint[] counts = Measure(Settings(), particles);
            Assert.That(counts[SpeedCounts.Bins - 1], Is.EqualTo(3));
            Assert.That(counts[0], Is.EqualTo(1));
            Assert.That(counts.Take(SpeedCounts.Bins).Sum(c => c), Is.EqualTo(65));
        }

        [Test]
        public void DistancesAreThoseFromTheKeptPlacesById([Values(1, 64, 257, 1009)] int count)
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Periodic = FluidAxes.X;
            FluidParticle[] before = Spread(count), after = Spread(count);
            var random = new System.Random(5);
            for (int i = 0; i < count; i++)
            {
                Vector3 moved = 0.03f * (float)random.NextDouble() * ParticleSets.RandomVector(random);
                after[i].Position = before[i].Position + moved;
                if (Mathf.Abs(after[i].Position.x) > 0.5f * Domain.x) after[i].Position.x -= Mathf.Sign(after[i].Position.x) * Domain.x;
            }
            double[] squares = Enumerable.Range(0, count).Select(i => Distance(after[i].Position, before[i].Position)).ToArray();
            after = after.OrderBy(_ => random.Next()).ToArray();
            using (var solver = new FluidSolver(settings, shaders, before))
            using (GraphicsBuffer counts = GpuBuffers.Create("Counts", SpeedCounts.Size, sizeof(uint)))
            using (GraphicsBuffer places = GpuBuffers.Create("Places", count, 16), claims = GpuBuffers.Create("Claims", count, 4))
            {
                var pass = new MeasureSpeedsPass(shaders);
                Record(solver, before, cmd => pass.RecordPlaces(cmd, solver, places, claims));
                Record(solver, after, cmd =>
                {
                    pass.Record(cmd, solver, counts);
                    pass.RecordDistances(cmd, solver, places, claims, counts);
                });
                AssertCounts(GpuTest.Read<uint>(counts, SpeedCounts.Size), SpeedCounts.Distances, squares, 1e-3);
            }
        }

        // Ids modulo 64: 3 and 67 share a place, and are left out. Who was born since, 100 here, is infinitely far.
        [Test]
        public void IdsThatShareAPlaceAreLeftOutAndWhoIsNewIsFar()
        {
            FluidParticle[] particles = Spread(60), later = Spread(60);
            particles[7].Id = later[7].Id = 67;
            particles[8].Id = later[8].Id = unchecked((uint)-1); // of 63, which nobody has
            later[9].Id = 100;
            FluidSolverSettings settings = Settings();
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (GraphicsBuffer counts = GpuBuffers.Create("Counts", SpeedCounts.Size, sizeof(uint)))
            using (GraphicsBuffer places = GpuBuffers.Create("Places", 64, 16), claims = GpuBuffers.Create("Claims", 64, 4))
            {
                var pass = new MeasureSpeedsPass(shaders);
                Record(solver, particles, cmd => pass.RecordPlaces(cmd, solver, places, claims));
                Record(solver, later, cmd =>
                {
                    pass.Record(cmd, solver, counts);
                    pass.RecordDistances(cmd, solver, places, claims, counts);
                });
                uint[] read = GpuTest.Read<uint>(counts, SpeedCounts.Size);
                Assert.That(read[SpeedCounts.Distances], Is.EqualTo(57));
                Assert.That(read[SpeedCounts.Distances + SpeedCounts.Bins - 1], Is.EqualTo(1));
            }
        }

        [Test]
        public void TheFastestOfTheStepsIsBesideTheCounts()
        {
            FluidParticle[] particles = Spread(257);
            using (var solver = new FluidSolver(Settings(), shaders, particles))
            using (GraphicsBuffer counts = GpuBuffers.Create("Counts", SpeedCounts.Size, sizeof(uint)))
            {
                var pass = new MeasureSpeedsPass(shaders);
                GpuTest.Run(cmd =>
                {
                    solver.RecordSteps(cmd, 2);
                    solver.RecordNeighbourSetup(cmd);
                    pass.Record(cmd, solver, counts);
                });
                SpeedSample sample = SpeedSample.Evaluate(GpuTest.Read<uint>(counts, SpeedCounts.Size), 3, 0.0);
                Assert.That(sample.Fastest, Is.EqualTo(solver.ReadCountersNow().MaxSpeed).And.Positive);
                Assert.That(sample.Kept, Is.EqualTo(3));
                float present = GpuTest.Read<FluidParticle>(solver.Particles, 257).Max(p => p.VelT0.magnitude);
                Assert.That(sample.Present, Is.InRange(present, 1.07f * present));
            }
        }

        [Test]
        public void CompressionIsItsMean([Values(1, 257, 1009)] int count)
        {
            using (var solver = new FluidSolver(Settings(), shaders, Spread(count)))
            using (GraphicsBuffer counts = GpuBuffers.Create("Counts", SpeedCounts.Size, sizeof(uint)))
            {
                var pass = new MeasureSpeedsPass(shaders);
                var random = new System.Random(3);
                float[] density = Enumerable.Range(0, count)
                    .Select(i => i % 7 == 3 ? float.NaN : solver.Settings.RestDensity * (0.5f + 2f * (float)random.NextDouble())).ToArray();
                GpuTest.Run(cmd =>
                {
                    solver.RecordNeighbourSetup(cmd);
                    cmd.SetBufferData(solver.Density, density);
                    pass.Record(cmd, solver, counts);
                });
                double expected = density.Sum(d => d > solver.Settings.RestDensity ? d / solver.Settings.RestDensity - 1.0 : 0.0) / count;
                Assert.That(SpeedSample.Evaluate(GpuTest.Read<uint>(counts, SpeedCounts.Size), 0, 0.0).Compression,
                    Is.EqualTo(expected).Within(1.0 / 64.0 * ((count + 255) / 256) / count + 1e-4));
            }
        }

        private uint[] Measure(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            FluidParticle[] start = particles.Select(p => new FluidParticle(p.Position, Vector3.zero, p.Id)).ToArray();
            using (var solver = new FluidSolver(settings, shaders, start))
            using (GraphicsBuffer counts = GpuBuffers.Create("Counts", SpeedCounts.Size, sizeof(uint)))
            {
                counts.SetData(Enumerable.Repeat(77u, SpeedCounts.Size).ToArray());
                var pass = new MeasureSpeedsPass(shaders);
                Record(solver, particles, cmd => pass.Record(cmd, solver, counts));
                return GpuTest.Read<uint>(counts, SpeedCounts.Size);
            }
        }

        // The pass reads what was published; here a test puts its own there.
        private static void Record(FluidSolver solver, FluidParticle[] particles, Action<CommandBuffer> record)
        {
            GpuTest.Run(solver.RecordNeighbourSetup);
            solver.Particles.SetData(particles);
            GpuTest.Run(record);
        }

        // A square next to a bin's edge may be rounded into either.
        private static void AssertCounts(uint[] counts, int kind, double[] squares, double rounding = 2e-5)
        {
            Assert.That(counts.Skip(kind).Take(SpeedCounts.Bins).Sum(c => c), Is.EqualTo(squares.Length));
            long found = 0;
            for (int bin = 0; bin < SpeedCounts.Bins; bin++)
            {
                found += counts[kind + bin];
                long surely = squares.Count(s => SpeedCounts.BinOf((float)(s * (1.0 + rounding))) <= bin);
                long perhaps = squares.Count(s => SpeedCounts.BinOf((float)(s * (1.0 - rounding))) <= bin);
                Assert.That(found, Is.InRange(surely, perhaps), $"up to bin {bin}");
            }
        }

        private static FluidParticle[] Spread(int count)
        {
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 1f, 12);
            for (int i = 0; i < count; i++) particles[i].VelT0 *= Mathf.Pow(10f, i % 9 - 5);
            return particles;
        }

        private static FluidSolverSettings Settings()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Domain;
            input.Spacing = 0.04f;
            input.LiquidHeight = Domain.y;
            input.LiquidDepth = 0.5f * Domain.y;
            input.Gravity = new Vector3(1f, -9f, 0.5f);
            return FluidRules.Derive(input);
        }

        private static double Potential(in FluidSolverSettings settings, Double3 x)
        {
            Double3 centre = (Double3)settings.BodyForce.Centre, rate = (Double3)settings.BodyForce.RateSquared,
                gravity = (Double3)settings.Gravity;
            return 0.5 * (rate.X * Math.Pow(x.X - centre.X, 2) + rate.Y * Math.Pow(x.Y - centre.Y, 2) +
                rate.Z * Math.Pow(x.Z - centre.Z, 2)) -
                Double3.Dot(gravity, x);
        }

        // Each axis by itself, in 20,001 places.
        private static double LowestByLattice(in FluidSolverSettings settings)
        {
            double lowest = 0.0;
            for (int axis = 0; axis < 3; axis++)
            {
                double least = double.PositiveInfinity;
                for (int i = 0; i <= 20000; i++)
                {
                    double x = settings.DomainSize[axis] * (i / 20000.0 - 0.5);
                    double offset = x - settings.BodyForce.Centre[axis];
                    least = Math.Min(least, 0.5 * settings.BodyForce.RateSquared[axis] * offset * offset - settings.Gravity[axis] * x);
                }
                lowest += least;
            }
            return lowest;
        }

        private static double Square(Vector3 v) => Double3.Dot(v, v);

        private static double Distance(Vector3 a, Vector3 b)
        {
            double x = (double)a.x - b.x, y = (double)a.y - b.y, z = (double)a.z - b.z;
            x -= Domain.x * Math.Round(x / Domain.x);
            return x * x + y * y + z * z;
        }
    }
}
