using NUnit.Framework;
using SphFluid.Editor;

namespace SphFluid.Tests
{
    /// <summary>The error class in words: never better for coarser liquid, and none where nothing was measured.</summary>
    public sealed class ErrorClassTextTests
    {
        [Test]
        public void FinerLiquidIsNeverOfAWorseClass()
        {
            char last = 'E';
            for (double depth = 10.0; depth < 60.0; depth += 0.5)
            {
                char now = ErrorClass.Describe(FluidMethodKind.Standard, 2.25, depth)[0];
                Assert.That((int)now, Is.LessThanOrEqualTo(last), $"{depth}");
                Assert.That("ABCD", Does.Contain(now.ToString()));
                last = now;
            }
            Assert.That(last, Is.EqualTo('A'));
        }

        [Test]
        public void AClassSaysWhatItMeans()
        {
            Assert.That(ErrorClass.Describe(FluidMethodKind.Standard, 2.25, 18.0), Is.EqualTo("A, waves within 2 %: 18 particles deep"));
            Assert.That(ErrorClass.Describe(FluidMethodKind.Standard, 2.25, 400.0), Does.StartWith("A, ").And.Contains("finer than the"));
        }

        [Test]
        public void WhatWasNotMeasuredHasNone()
        {
            Assert.That(ErrorClass.Describe(FluidMethodKind.Standard, 2.25, 3.0),
                Does.StartWith("none: 3 particles deep, and waves were measured with"));
            Assert.That(ErrorClass.Describe(FluidMethodKind.Standard, 3.0, 20.0),
                Does.StartWith("none: waves were not measured").And.Contains("κ = 3"));
            Assert.That(ErrorClass.Describe(FluidMethodKind.Thesis, 2.0, 20.0), Does.StartWith("none: "));
        }
    }
}
