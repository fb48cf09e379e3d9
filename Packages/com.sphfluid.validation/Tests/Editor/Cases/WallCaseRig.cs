using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Runs a case to its end.</summary>
    static class WallCaseRig
    {
        /// <summary>The base of a method with so many particles along the case's length.</summary>
        public static CaseParameters Coarse(ValidationCase flow, CaseMethod method, int resolution)
        {
            CaseParameters parameters = flow.Base(method);
            parameters.Resolution = resolution;
            return parameters;
        }

        /// <summary>The main error of a run that must not fail.</summary>
        public static double MainError(ValidationCase flow, CaseParameters parameters, out CaseMetric metric)
        {
            CaseResult result = Run(flow, parameters, SurfaceTestScene.LoadShaders(), out metric);
            Assert.That(result.Failure, Is.Null);
            return result.Errors[0].Value;
        }

        public static CaseResult Run(ValidationCase flow, CaseParameters parameters, FluidShaderSet shaders, out CaseMetric metric)
        {
            CaseSetup setup = flow.Build(parameters);
            return Run(flow, parameters, setup, shaders, out metric);
        }

        public static CaseResult Run(ValidationCase flow, CaseParameters parameters, CaseSetup setup, FluidShaderSet shaders, out CaseMetric metric)
        {
            metric = flow.CreateMetric(parameters, setup);
            using (var run = new CaseRun(setup, metric, shaders))
            {
                CaseResult result = run.RunToEnd();
                TestContext.WriteLine($"{flow.Name}: {result.Particles} particles, {result.Steps} steps, {result.Failure ?? "no failure"}");
                foreach (CaseError error in result.Errors)
                    TestContext.WriteLine($"  {error.Name}: {error.Value:0.####}");
                return result;
            }
        }
    }
}
