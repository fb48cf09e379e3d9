using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Why a column at rest reads a slope of the pressure that is more than a per cent off, however fine it is: κ 2.25, the method Standard.</summary>
    public sealed class SettledPackingTests
    {
        FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(13)]
        [TestCase(20)]
        public void TheSlopeIsWhatTheSettledPackingMakesOfAPressure(int resolution)
        {
            var flow = new HydrostaticCase();
            CaseParameters parameters = flow.Base(CaseMethod.Find("standard"));
            parameters.Resolution = resolution;
            CaseSetup setup = flow.Build(parameters);
            var slope = (HydrostaticMetric)flow.CreateMetric(parameters, setup);
            var settled = new SettledPackingMetric(setup.Settings, 0.98 * setup.Duration);
            using (var run = new CaseRun(setup, new Both(slope, settled), shaders))
                Assert.That(run.RunToEnd().Failure, Is.Null);
            double read = WallCaseStates.Named(slope, "slope/(ρg), as read");
            TestContext.WriteLine($"slope {read:0.0000}, moment along y {settled.Moment:0.0000}, across {settled.MomentAcross:0.0000}");

            Assert.That(read, Is.EqualTo(1.014).Within(0.006));
            Assert.That(settled.Moment, Is.EqualTo(0.986).Within(0.002), "at any spacing");
            Assert.That(read * settled.Moment, Is.EqualTo(1).Within(0.006), "the forces balance");
        }

        sealed class Both : CaseMetric
        {
            readonly CaseMetric first, second;

            public Both(CaseMetric first, CaseMetric second) => (this.first, this.second) = (first, second);

            public override void Sample(double time, FluidSnapshot state)
            {
                first.Sample(time, state);
                second.Sample(time, state);
                Failure = first.Failure;
            }

            public override IReadOnlyList<CaseError> Evaluate() => first.Evaluate();
        }
    }
}
