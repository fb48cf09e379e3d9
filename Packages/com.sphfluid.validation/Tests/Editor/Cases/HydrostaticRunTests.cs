using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The column at rest on the GPU, by the Standard method at its default κ.</summary>
    public sealed class HydrostaticRunTests
    {
        FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void PressureAndHeightFollowTheEquationOfState([Values(false, true)] bool walls)
        {
            var flow = new HydrostaticCase { Walls = walls };
            CaseParameters parameters = flow.Base(CaseMethod.Find("standard"));
            parameters.SupportRatio = 2.25;
            CaseResult result = WallCaseRig.Run(flow, parameters, shaders, out CaseMetric metric);

            Assert.That(result.Failure, Is.Null);
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.ErrorName), Is.LessThan(0.05));
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.FaceName), Is.EqualTo(1).Within(0.1));
            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.Zero.Within(0.015));
            Assert.That(WallCaseStates.Named(metric, "v_rms/√(gH)"), Is.LessThan(0.02));
            if (walls)
                Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.EdgesName), Is.EqualTo(1).Within(0.25));
        }
    }
}
