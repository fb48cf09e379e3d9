using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>
    /// Why a column at rest reads a slope of the pressure that is more than a per cent off, however fine it is: κ 2.25, the method
    /// Standard.
    /// </summary>
    public sealed class SettledPackingTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void TheSlopeIsWhatTheSettledPackingMakesOfAPressure() => Check(13, 7.0, 10.0);

        [Test]
        [Explicit("The case at its own size, which tells that the packing does not go with the spacing: a minute.")]
        public void SoItIsInTheWholeCase() => Check(20, 15.0, 20.0);

        private void Check(int resolution, double begin, double end)
        {
            var flow = new HydrostaticCase();
            CaseParameters parameters = flow.Base(CaseMethod.Find("standard"));
            parameters.Resolution = resolution;
            CaseSetup setup = flow.Build(parameters);
            HydrostaticMetric slope = WallCaseRig.Shorter(setup, begin, end);
            var settled = new SettledPackingMetric(setup.Settings, 0.98 * setup.Duration);
            Assert.That(WallCaseRig.Run(flow.Name, setup, new Both(slope, settled), shaders).Failure, Is.Null);
            double read = WallCaseStates.Named(slope, "slope/(ρg), as read");
            TestContext.WriteLine($"slope {read:0.0000}, moment along y {settled.Moment:0.0000}, across {settled.MomentAcross:0.0000}");

            Assert.That(read, Is.EqualTo(1.014).Within(0.006));
            Assert.That(settled.Moment, Is.EqualTo(0.986).Within(0.002), "at any spacing");
            Assert.That(read * settled.Moment, Is.EqualTo(1).Within(0.006), "the forces balance");
            Assert.That(WallCaseStates.Named(slope, HydrostaticMetric.FaceName), Is.EqualTo(1).Within(0.1));
            Assert.That(WallCaseStates.Named(slope, "height lost beyond the equation of state's"), Is.Zero.Within(0.3 / resolution),
                "of a spacing");
            Assert.That(WallCaseStates.Named(slope, "v_rms/√(gH)"), Is.LessThan(0.02));
        }

        private sealed class Both : CaseMetric
        {
            private readonly CaseMetric first, second;

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
