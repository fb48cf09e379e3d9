using System;
using NUnit.Framework;
using SphFluid.Validation;
namespace SphFluid.Tests
{
    public sealed class TmpMismatch
    {
        [TestCase(2.0, 0.4, 0.0)]
        [TestCase(2.0, 0.1, 0.0)]
        [TestCase(2.0, 0.4, 0.02)]
        [TestCase(2.5, 0.4, 0.02)]
        public void Run(double kappa, double fraction, double nu)
        {
            FluidShaderSet shaders = TestShaders.CreateThesisSet();
            double c = 10, R = 0.1 * kappa;
            var run = new StabilityRun { Method = CaseMethod.Find("thesis"), Seed = 1 };
            CaseSetup setup = StabilityScenes.Box(run, kappa, c, fraction * 1.37 * R / c, nu * c * R, 0.0).Setup;
            setup.SampleInterval = setup.Duration / 20;
            var m = new M();
            using (var real = new CaseRun(setup, m, shaders)) { var r = real.RunToEnd(); Assert.Fail($"kappa {kappa} f {fraction} nu {nu}: v/c_nominal {m.V / c} fail {r.Failure} steps {r.Steps}"); }
        }
        sealed class M : CaseMetric
        {
            public double V;
            public override void Sample(double t, FluidSnapshot s) { double q = 0; foreach (var v in s.Velocities) q += v.sqrMagnitude; V = Math.Sqrt(q / s.Count); }
            public override System.Collections.Generic.IReadOnlyList<CaseError> Evaluate() => Array.Empty<CaseError>();
        }
    }
}
