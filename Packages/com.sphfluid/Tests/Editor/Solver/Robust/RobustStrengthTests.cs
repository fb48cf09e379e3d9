using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid that is thrown about in a box neither gains energy nor leaves it, however few steps a frame has.</summary>
    public sealed class RobustStrengthTests
    {
        private const float Frame = 1f / 60f;

        [TestCase(4, 0.93)]
        [TestCase(1, 0.85)]
        public void AThrownBlockKeepsItsEnergyAndComesToRest(int substeps, double leastHeight)
        {
            using (RobustLiquid block = RobustLiquid.Thrown(FluidMethodKind.Robust, 5))
            {
                double start = block.Energy(), most = 0.0;
                float fastest = 4f;
                for (int frame = 0; frame < 80; frame++)
                {
                    block.Solver.PeakSpeed = fastest;
                    block.Frame(substeps, Frame / substeps);
                    most = Math.Max(most, block.Energy());
                    fastest = Mathf.Min(1000f, block.Solver.Counters.MaxSpeed);
                }
                FluidCounters counters = block.Solver.ReadCountersNow();
                double height = block.Height() / (8.0 * block.Settings.Spacing);
                TestContext.Out
                    .WriteLine(
                        $"{substeps} substeps: most {most / start:0.0000} of the energy, height {height:0.000}, clamps " +
                        $"{counters.DomainClamps}");
                Assert.That(most / start, Is.LessThan(1.02));
                Assert.That(counters.NonFinite, Is.Zero);
                Assert.That(counters.DomainClamps, Is.Zero);
                Assert.That(height, Is.InRange(leastHeight, 1.05));
            }
        }
    }
}
