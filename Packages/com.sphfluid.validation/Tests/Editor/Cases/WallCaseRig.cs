using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Runs a case to its end.</summary>
    static class WallCaseRig
    {
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
