using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AnswerPoints against sums over all particles in double precision.</summary>
    public sealed class AnswerPointsTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f), Place = new Vector3(3f, -2f, 1f);
        private static readonly Quaternion Turn = Quaternion.Euler(20f, 130f, -40f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void TearDown() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        [TestCase(257, FluidAxes.X | FluidAxes.Z)]
        public void AnswersAgreeWithSumsOverAllParticles(int points, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] particles = ParticleSets.Random(1500, Domain, 1f, 3);
            var random = new System.Random(4);
            var places = new Vector3[points];
            var queries = new Vector4[points];
            for (int i = 0; i < points; i++)
            {
                places[i] = Vector3.Scale(ParticleSets.RandomVector(random), 0.999f * Domain);
                Vector3 world = Place + Turn * places[i];
                queries[i] = new Vector4(world.x, world.y, world.z, BitConverter.Int32BitsToSingle(i + 1));
            }
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (GraphicsBuffer asked = GpuBuffers.Create("Queries", points, 16),
                answers = GpuBuffers.Create("Results", points, FluidPointResult.Stride))
            {
                if (points > 0) asked.SetData(queries);
                var pass = new AnswerPointsPass(shaders);
                GpuTest.Run(cmd =>
                {
                    solver.RecordNeighbourSetup(cmd);
                    pass.Record(cmd, new QueryTarget { Solver = solver, Position = Place, Rotation = Turn, Results = answers },
                        asked, points, 0);
                });
                FluidPointResult[] found = ReadResults(answers, points);
                int wet = 0;
                for (int i = 0; i < points; i++)
                {
                    (double density, Double3 velocity) = Expected(places[i], particles, settings);
                    Assert.That(found[i].Generation, Is.EqualTo(i + 1));
                    Assert.That(found[i].Density, Is.EqualTo(density).Within(1e-4 * settings.RestDensity));
                    Vector3 v = Quaternion.Inverse(Turn) * found[i].Velocity;
                    if (density > 0.1 * settings.RestDensity)
                    {
                        Assert.That((v - new Vector3((float)velocity.X, (float)velocity.Y, (float)velocity.Z)).magnitude,
                            Is.LessThan(1e-4));
                    }
                    if (Math.Abs(density / settings.RestDensity - 0.5) > 1e-3)
                    {
                        Assert.That(found[i].IsWet, Is.EqualTo(density > 0.5 * settings.RestDensity));
                    }
                    wet += found[i].IsWet ? 1 : 0;
                }
                if (points > 1) Assert.That(wet, Is.InRange(1, points - 1));
            }
        }

        private static FluidPointResult[] ReadResults(GraphicsBuffer answers, int points)
        {
            var found = new FluidPointResult[points];
            if (points > 0) answers.GetData(found);
            return found;
        }

        private static (double density, Double3 velocity) Expected(Vector3 place, FluidParticle[] particles,
            in FluidSolverSettings settings)
        {
            double sum = 0.0, radius = settings.SupportRadius, part = 1.0;
            Vector3 period = settings.PeriodLength;
            Double3 velocity = Double3.Zero;
            foreach (FluidParticle particle in particles)
            {
                double squared = 0.0;
                for (int axis = 0; axis < 3; axis++)
                {
                    double d = (double)place[axis] - particle.Position[axis];
                    if (period[axis] > 0f) d -= period[axis] * Math.Round(d / period[axis]);
                    squared += d * d;
                }
                double weight = StandardReference.Kernel(Math.Sqrt(squared), radius);
                sum += weight;
                velocity += weight * (Double3)particle.VelT0;
            }
            for (int axis = 0; axis < 3; axis++)
                if (!(period[axis] > 0f))
                {
                    part *= Inside((0.5 * settings.DomainSize[axis] + place[axis]) / radius) +
                        Inside((0.5 * settings.DomainSize[axis] - place[axis]) / radius) - 1.0;
                }
            return (settings.ParticleMass * sum / Math.Max(part, 0.125), (1.0 / Math.Max(sum, 1e-30)) * velocity);
        }

        // Wendland's kernel on the inner side of a plane, by shells: of one with radius q R the part 1/2 + s/(2q) lies there.
        private static double Inside(double s)
        {
            const int shells = 2000;
            double sum = 0.0;
            for (int i = 0; i < shells; i++)
            {
                double q = (i + 0.5) / shells;
                sum += 4.0 * Math.PI * q * q * StandardReference.Kernel(q, 1.0) * Math.Min(1.0, 0.5 + 0.5 * s / q) / shells;
            }
            return sum;
        }
    }
}
