using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Which liquids' steps a chart times, and its lines.</summary>
    public sealed class StepCostRunTests
    {
        [Test]
        public void EveryMethodThatIsRunWithManyNumbersIsTimedFromFewParticlesToMany()
        {
            foreach (bool software in new[] { false, true })
            {
                IReadOnlyList<StepCostPoint> points = StepCostPoint.Of(CaseMethod.All, false, software);

                Assert.That(points.Select(p => p.Key), Is.Unique);
                Assert.That(points.Any(p => p.Method.Kind == FluidMethodKind.ThesisPrinted), Is.False);
                foreach (IGrouping<string, StepCostPoint> own in points.GroupBy(p => p.Method.Name + p.SupportRatio))
                {
                    Assert.That(own.Max(p => p.Particles) / (double)own.Min(p => p.Particles), Is.GreaterThan(50.0), own.Key);
                    // Some share a padded length, some do not: a sort's padding can be told from what a particle costs.
                    Assert.That(own.GroupBy(p => (int)System.Math.Ceiling(System.Math.Log(p.Particles, 2.0))).Any(g => g.Count() > 1),
                        Is.True, own.Key);
                }
            }
        }

        [Test]
        public void AShortChartTimesFewer()
        {
            Assert.That(StepCostPoint.Of(CaseMethod.All, true, true).Count,
                Is.LessThan(StepCostPoint.Of(CaseMethod.All, false, true).Count / 3));
        }

        [Test]
        public void ALineIsReadAsItWasWritten()
        {
            var point = new StepCostPoint(CaseMethod.Find("standard"), 2.25, 4200);
            StepCostRow row = StepCostRow.Of(point, 120, StepTimes.Of(new[] { 2.0, 4.0, 6.0 }, new[] { 1, 1, 1 }));
            (row.Device, row.Date) = ("device", "2026-11-25");
            var read = new StepCostRow();
            StepCostRow.Format.Read(StepCostRow.Format.Line(row), read);

            Assert.That(StepCostRow.Format.Line(row), Is.EqualTo("standard,2.25,4200,120,4,3,5,0.5,device,2026-11-25"));
            Assert.That(read.Key, Is.EqualTo(point.Key));
            Assert.That((read.Milliseconds, read.Low, read.High), Is.EqualTo((4.0, 3.0, 5.0)));
        }
    }
}
