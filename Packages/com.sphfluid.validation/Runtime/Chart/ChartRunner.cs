using System;
using System.Collections;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Does the chart's runs on the GPU.</summary>
    internal sealed class ChartRunner
    {
        private readonly FluidShaderSet shaders;

        /// <exception cref="FluidDeviceException">The device has no GPU times, or there are no shaders.</exception>
        public ChartRunner(FluidShaderSet shaders)
        {
            this.shaders = SessionAssets.Require(shaders, "The chart has");
            if (!SystemInfo.supportsGpuRecorder)
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times in Unity's profiler. " +
                    "Draw the chart with Direct3D 11 or 12.");
            }
        }

        public IEnumerator Run(ChartRun run, Action<CaseResult> done)
        {
            using (CaseRun caseRun = Create(run, out string problem))
            {
                if (caseRun == null)
                {
                    done(new CaseResult { Failure = "it cannot be set up: " + problem });
                    yield break;
                }
                yield return caseRun.Run();
                done(caseRun.Result);
            }
        }

        private CaseRun Create(ChartRun run, out string problem)
        {
            problem = null;
            CaseParameters parameters = run.Config.Parameters(run.Seed);
            try
            {
                CaseSetup setup = run.Config.Case.Build(parameters);
                return new CaseRun(setup, run.Config.Case.CreateMetric(parameters, setup), shaders, true);
            }
            catch (ArgumentException exception)
            {
                problem = exception.Message;
                return null;
            }
        }
    }
}
