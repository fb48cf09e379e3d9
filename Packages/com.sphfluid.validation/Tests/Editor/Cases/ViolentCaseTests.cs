using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A block thrown in a box: the metric on states made by hand, and coarse runs.</summary>
    public sealed class ViolentCaseTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => Object.DestroyImmediate(shaders);

        private static CaseParameters At(string method, int resolution, double fraction = 0.75)
        {
            CaseParameters parameters = new ViolentCase().Base(CaseMethod.Find(method));
            parameters.Resolution = resolution;
            parameters.TimeStepFraction = fraction;
            return parameters;
        }

        [Test]
        public void TheBaseCutsAFrameIntoFourSteps()
        {
            CaseSetup setup = new ViolentCase().Build(At("robust", 16));
            Assert.That(setup.Settings.TimeStep, Is.EqualTo(1.0 / 240.0).Within(1e-4).Percent);
            Assert.That(setup.Particles.Length, Is.EqualTo(3200));
            Assert.That(new ViolentCase().Build(At("standard", 16)).Settings.TimeStep, Is.LessThan(1.0 / 600.0));
        }

        [Test]
        public void EnergyHeightAndDensityAreThoseOfTheStates()
        {
            FluidSolverSettings settings = new ViolentCase().Build(At("robust", 8)).Settings;
            float floor = -0.5f * settings.DomainSize.y;
            FluidParticle[] Particles(float height, float speed) => new[]
            {
                new FluidParticle(new Vector3(0f, floor + height, 0f), new Vector3(speed, 0f, 0f), 0),
                new FluidParticle(new Vector3(0.1f, floor + 3f * height, 0f), Vector3.zero, 1),
            };
            var metric = new ViolentMetric(settings, 0.2);
            metric.Sample(0.0, CaseStates.State(Particles(0.1f, 2f))); // 1 + 2 g 0.1
            metric.Sample(0.1, CaseStates.State(Particles(0.05f, 3f), 1200f)); // 2.25 + g 0.1
            double first = 1.0 + 0.2 * 9.81, second = 2.25 + 0.1 * 9.81;
            double[] errors = metric.Evaluate().Select(e => e.Value).ToArray();
            Assert.That(errors[0], Is.EqualTo(second / first - 1.0).Within(1e-4));
            Assert.That(errors[1], Is.EqualTo(2.0 * 0.1 / 0.2).Within(1e-4));
            Assert.That(errors[2], Is.EqualTo(1.2).Within(1e-6));
            Assert.That(errors[3], Is.EqualTo(System.Math.Sqrt(4.5)).Within(1e-4));
            Assert.That(metric.Series()[0].Y[1], Is.EqualTo(second / first).Within(1e-4));
        }

        [Test]
        public void NothingIsGainedAndNobodyLeaves() => RequireNoGain("robust", 8, 1.5);

        [Explicit("The table of the paper Robust: a minute.")]
        [TestCase("standard", 0.75)]
        [TestCase("robust", 0.75)]
        [TestCase("robust", 1.5)]
        [TestCase("robust", 3.0)]
        public void NothingIsGainedByTheWholeCase(string method, double fraction) => RequireNoGain(method, 16, fraction);

        private void RequireNoGain(string method, int resolution, double fraction)
        {
            var validationCase = new ViolentCase();
            CaseParameters parameters = At(method, resolution, fraction);
            CaseResult result = WallCaseRig.Run(validationCase, parameters, shaders, out _);
            Assert.That(result.Failure, Is.Null);
            TestContext.Out.WriteLine(string.Join(", ", result.Errors.Select(e => $"{e.Name} {e.Value:G4}")));
            Assert.That(result.Errors[0].Value, Is.LessThan(validationCase.Limit));
            Assert.That(result.Errors[1].Value, Is.InRange(0.9, 1.1));
        }
    }
}
