using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>A column that has come to rest stays there.</summary>
    public sealed class RobustRestTests
    {
        const float TimeStep = 0.02f; // in sqrt(H/g)

        // Frames of 5 steps; damped for a while, then free.
        static RobustLiquid Settled()
        {
            RobustLiquid column = RobustLiquid.Column(TimeStep, 4, 12);
            for (int frame = 0; frame < 220; frame++)
            {
                column.Frame(5);
                if (frame < 30 && frame % 2 == 0) column.Damp(0.2f);
            }
            return column;
        }

        [Test]
        public void LiquidAtRestIsCalm()
        {
            using (RobustLiquid column = Settled())
            {
                double sum = 0.0;
                for (int frame = 0; frame < 20; frame++)
                {
                    column.Frame(5);
                    sum += column.Speed() / 20.0;
                }
                TestContext.Out.WriteLine($"v_rms {sum:G3} of sqrt(g H)");
                Assert.That(sum, Is.LessThan(0.002));
            }
        }

        // Stiffness goes as the step's inverse square: without the memory each change lifts or drops the liquid by a part of its compression.
        [TestCase(true)]
        [TestCase(false)]
        public void FramesThatVaryMoveItLittle(bool remembers)
        {
            using (RobustLiquid column = Settled())
            {
                var random = new Random(1);
                var clock = new FrameClock(5, 1.0, 5, TimeStep);
                double sum = 0.0;
                for (int frame = 0; frame < 60; frame++)
                {
                    int steps = clock.Advance(5.0 * TimeStep * (0.8 + 0.4 * random.NextDouble()));
                    if (remembers) column.Solver.LongestStep = (float)clock.LongestOfLate;
                    column.Frame(steps, (float)clock.TimeStep);
                    sum += column.Speed() / 60.0;
                }
                TestContext.Out.WriteLine($"steps that vary by a fifth, {(remembers ? "remembered" : "each alone")}: v_rms {sum:G3} of sqrt(g H)");
                if (remembers) Assert.That(sum, Is.LessThan(0.02));
                else Assert.That(sum, Is.GreaterThan(0.022), "the memory is what it is for");
            }
        }
    }
}
