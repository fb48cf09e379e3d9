using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>
    /// The column at rest between four walls on the GPU, by the Standard method at its default κ; <see cref="SettledPackingTests"/> has the
    /// one without.
    /// </summary>
    public sealed class HydrostaticRunTests
    {
        [Test]
        public void PressureAndHeightFollowTheEquationOfState() => Check(10, 10.0, 14.0);

        [Test]
        [Explicit("The case at its own size: two minutes.")]
        public void SoTheyDoInTheWholeCase() => Check(20, 15.0, 20.0);

        private static void Check(int resolution, double begin, double end)
        {
            var flow = new HydrostaticCase { Walls = true };
            CaseSetup setup = flow.Build(WallCaseRig.Coarse(flow, CaseMethod.Find("standard"), resolution));
            HydrostaticMetric metric = WallCaseRig.Shorter(setup, begin, end);

            Assert.That(WallCaseRig.Run(flow.Name, setup, metric, SurfaceTestScene.LoadShaders()).Failure, Is.Null);
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.ErrorName), Is.LessThan(0.05));
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.FaceName), Is.EqualTo(1).Within(0.1));
            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.Zero.Within(0.3 / resolution),
                "of a spacing");
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.LessThan(0.02));
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.EdgesName), Is.EqualTo(1).Within(0.25));
        }
    }
}
