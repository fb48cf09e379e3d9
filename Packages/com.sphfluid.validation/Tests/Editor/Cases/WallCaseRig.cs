using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Runs a case to its end.</summary>
    internal static class WallCaseRig
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

        /// <summary>
        /// Shortens a column at rest, and what averages it from a time on, both in √(H/g): it starts as it stands, so that it need not go
        /// on for 20.
        /// </summary>
        public static HydrostaticMetric Shorter(CaseSetup column, double begin, double end)
        {
            const double depth = 1.0;
            double time = Math.Sqrt(depth / 9.81);
            int width = Mathf.RoundToInt(column.Settings.DomainSize.x / column.Settings.Spacing);
            column.Duration = end * time;
            return new HydrostaticMetric(column.Settings, depth, width * width, begin * time);
        }

        /// <summary>The largest error of the profiles of the first 20 s: until then four fifths of the flow have started.</summary>
        public static double StartUpError(ChannelCase channel, CaseParameters parameters)
        {
            CaseSetup setup = channel.Build(parameters);
            setup.Duration = 20.0;
            CaseMetric metric = channel.CreateMetric(parameters, setup);
            Assert.That(Run(channel.Name, setup, metric, SurfaceTestScene.LoadShaders()).Failure, Is.Null);
            double[] errors = metric.Evaluate().Where(e => e.Name.StartsWith("profile, L2") && !double.IsNaN(e.Value))
                .Select(e => e.Value).ToArray();
            Assert.That(errors, Has.Length.EqualTo(3), "at 2, 10 and 20 s");
            return errors.Max();
        }

        public static CaseResult Run(ValidationCase flow, CaseParameters parameters, FluidShaderSet shaders, out CaseMetric metric)
        {
            CaseSetup setup = flow.Build(parameters);
            return Run(flow, parameters, setup, shaders, out metric);
        }

        public static CaseResult Run(ValidationCase flow, CaseParameters parameters, CaseSetup setup, FluidShaderSet shaders,
            out CaseMetric metric)
        {
            metric = flow.CreateMetric(parameters, setup);
            return Run(flow.Name, setup, metric, shaders);
        }

        public static CaseResult Run(string name, CaseSetup setup, CaseMetric metric, FluidShaderSet shaders)
        {
            using (var run = new CaseRun(setup, metric, shaders))
            {
                CaseResult result = run.RunToEnd();
                TestContext.WriteLine($"{name}: {result.Particles} particles, {result.Steps} steps, {result.Failure ?? "no failure"}");
                foreach (CaseError error in result.Errors) TestContext.WriteLine($"  {error.Name}: {error.Value:0.####}");
                return result;
            }
        }
    }
}
