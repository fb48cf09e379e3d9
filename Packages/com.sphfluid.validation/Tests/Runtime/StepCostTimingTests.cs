using System.Collections;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The timing of a liquid's step: that it comes to an end with times, not what they are.</summary>
    public sealed class StepCostTimingTests
    {
        [UnityTest]
        public IEnumerator EveryMethodHasATime()
        {
            GpuTest.Require();
            if (!SystemInfo.supportsGpuRecorder)
            {
                Assert.Ignore($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times.");
            }
            foreach (CaseMethod method in CaseMethod.All.Where(m => m.Kind != FluidMethodKind.ThesisPrinted))
            {
                StepCostRow row = null;
                var work =
                    new SessionWork(
                        new StepCostRun(SessionAssets.PackageShaders) { LeastSeconds = 0.01 }
                            .Run(new StepCostPoint(method, method.SupportRatio, 300), r => row = r));
                while (work.Step()) yield return null;
                Assert.That(row.Steps, Is.GreaterThanOrEqualTo(12), method.Name);
                Assert.That(row.Milliseconds, Is.GreaterThan(0.0), method.Name);
                Assert.That(row.Low, Is.LessThanOrEqualTo(row.Milliseconds), method.Name);
                Assert.That(row.High, Is.GreaterThanOrEqualTo(row.Milliseconds), method.Name);
            }
        }
    }
}
