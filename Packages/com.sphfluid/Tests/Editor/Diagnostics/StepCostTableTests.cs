using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>Costs of steps: kept by size, read between and beyond the sizes, never made up.</summary>
    public sealed class StepCostTableTests
    {
        private static readonly StepCostKey Key = StepCostKey.Create(FluidMethodKind.Standard, 2.25, false);

        private StepCostTable table;

        [SetUp]
        public void SetUp() => table = new StepCostTable();

        [Test]
        public void NothingIsMadeUp()
        {
            Assert.That(table.TryFind(Key, 1000, out _), Is.False);
            Note(1000, 1.0);
            Assert.That(table.TryFind(Key, 0, out _), Is.False);
            Assert.That(table.TryFind(StepCostKey.Create(FluidMethodKind.Thesis, 2.25, false), 1000, out _), Is.False, "another method");
            Assert.That(table.TryFind(StepCostKey.Create(FluidMethodKind.Standard, 2.0, false), 1000, out _), Is.False,
                "another support radius");
            Assert.That(table.TryFind(StepCostKey.Create(FluidMethodKind.Standard, 2.25, true), 1000, out _), Is.False, "bodies");
        }

        [TestCase(0, 1.0)]
        [TestCase(-5, 1.0)]
        [TestCase(10, 0.0)]
        [TestCase(10, -1.0)]
        [TestCase(10, double.NaN)]
        [TestCase(10, double.PositiveInfinity)]
        public void WrongMeasurementsAreNotKept(int particles, double milliseconds)
        {
            Assert.That(Note(particles, milliseconds), Is.False);
            Assert.That(table.Count, Is.Zero);
        }

        // 1000: 0.2 ms, 4000: 0.5 ms: 0.1 ms a step and 0.1 µs a particle.
        [TestCase(1000, 0.2)]
        [TestCase(2000, 0.3)]
        [TestCase(4000, 0.5)]
        [TestCase(10000, 1.1)]
        [TestCase(500, 0.15)]
        [TestCase(1, 0.1001)]
        public void TwoSizesMakeALine(int particles, double expected)
        {
            Note(1000, 0.2);
            Note(4000, 0.5);
            Assert.That(Found(particles), Is.EqualTo(expected).Within(1e-12));
        }

        [TestCase(100, 0.1)]
        [TestCase(1000, 1.0)]
        [TestCase(3000, 3.0)]
        public void OneSizeIsInProportion(int particles, double expected)
        {
            Note(1000, 1.0);
            Assert.That(Found(particles), Is.EqualTo(expected).Within(1e-12));
        }

        [Test]
        public void ALineThatFallsDoesNotLeadBelowMeasuredCosts()
        {
            Note(1000, 1.0); // timed on a busy device
            Note(4000, 0.5);
            Assert.That(Found(100000), Is.EqualTo(0.5), "no less than with fewer particles");
            Assert.That(Found(100), Is.EqualTo(1.0).Within(1e-12));
        }

        [Test]
        public void TheNearestNumberIsSaid()
        {
            Note(1000, 1.0);
            Note(16000, 9.0);
            Assert.That(Nearest(100), Is.EqualTo(1000));
            Assert.That(Nearest(3999), Is.EqualTo(1000));
            Assert.That(Nearest(4001), Is.EqualTo(16000));
            Assert.That(Nearest(1000000), Is.EqualTo(16000));
            Assert.That(table.TryFind(Key, 32000, out StepCost near) && StepCostTable.IsNear(near, 32000));
            Assert.That(table.TryFind(Key, 32001, out StepCost far) && StepCostTable.IsNear(far, 32001), Is.False);
            Assert.That(table.TryFind(Key, 499, out StepCost below) && StepCostTable.IsNear(below, 499), Is.False);
        }

        [Test]
        public void PlayKnowsBetterThanAStart()
        {
            Note(1000, 1.0, false);
            Note(1010, 2.0, true);
            Assert.That(table.Count, Is.EqualTo(1), "of one power of two");
            Assert.That(Found(1010), Is.EqualTo(2.0));
            Assert.That(Note(1010, 3.0, false), Is.False);
            Assert.That(Found(1010), Is.EqualTo(2.0));
            Note(1010, 4.0, true);
            Assert.That(Found(1010), Is.EqualTo(4.0), "the last of play");
        }

        [Test]
        public void WhatIsWrittenIsRead()
        {
            Note(1000, 0.1, true);
            Note(100000, 1.0 / 3.0, false);
            StepCostTable read = StepCostTable.Parse(table.ToText());
            Assert.That(read.ToText(), Is.EqualTo(table.ToText()));
            Assert.That(read.TryFind(Key, 100000, out StepCost cost) && System.Math.Abs(cost.Milliseconds - 1.0 / 3.0) < 1e-12 &&
                !cost.InPlay);
        }

        [Test]
        public void ForgottenCostsAreGone()
        {
            Note(1000, 1.0);
            table.Forget(Key);
            Assert.That(table.TryFind(Key, 1000, out _), Is.False);
        }

        private bool Note(long particles, double milliseconds, bool inPlay = true) =>
            table.Record(Key, new StepCost { Particles = particles, Milliseconds = milliseconds, InPlay = inPlay });

        private double Found(long particles) => table.TryFind(Key, particles, out StepCost cost) ? cost.Milliseconds : double.NaN;

        private long Nearest(long particles) => table.TryFind(Key, particles, out StepCost cost) ? cost.Particles : 0;
    }
}
