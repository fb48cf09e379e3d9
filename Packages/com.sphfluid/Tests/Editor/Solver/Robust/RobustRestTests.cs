using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>A column that has come to rest stays there.</summary>
    public sealed class RobustRestTests
    {
        private const float TimeStep = 0.02f; // in sqrt(H/g)

        // Stiffness goes as the step's inverse square: without the memory each change of the steps lifts or drops the liquid by a part of
        // its compression.
        [Test]
        public void LiquidAtRestIsCalmAndFramesThatVaryMoveItLittle() => Check(10, 100, 20, 0.0045);

        [Test]
        [Explicit("The figures of the paper Robust: half a minute.")]
        public void SoItIsForLonger() => Check(12, 220, 60, 0.002);

        private static void Check(int layers, int settling, int frames, double calmest)
        {
            using (RobustLiquid column = RobustLiquid.Column(TimeStep, 4, layers))
            {
                Settle(column, settling);
                double calm = MeanSpeed(column, 20, () => column.Frame(5));
                double remembered = MeanSpeed(column, frames, Varied(column, true)),
                    alone = MeanSpeed(column, frames, Varied(column, false));

                string figures =
                    $"v_rms {calm:G3} of sqrt(g H); steps that vary by a fifth, remembered: {remembered:G3}, each alone: {alone:G3}";
                TestContext.Out.WriteLine(figures);
                Assert.That(calm, Is.LessThan(calmest), figures);
                Assert.That(remembered, Is.LessThan(0.02), figures);
                Assert.That(alone, Is.GreaterThan(0.02), figures + ": the memory is what it is for");
            }
        }

        // Frames of 5 steps; damped for a while, then free.
        private static void Settle(RobustLiquid column, int frames)
        {
            for (int frame = 0; frame < frames; frame++)
            {
                column.Frame(5);
                if (frame < 30 && frame % 2 == 0) column.Damp(0.2f);
            }
        }

        private static Action Varied(RobustLiquid column, bool remembers)
        {
            var random = new Random(1);
            var clock = new FrameClock(5, 1.0, 5, TimeStep);
            return () =>
            {
                int steps = clock.Advance(5.0 * TimeStep * (0.8 + 0.4 * random.NextDouble()));
                column.Solver.LongestStep = remembers ? (float)clock.LongestOfLate : 0f;
                column.Frame(steps, (float)clock.TimeStep);
            };
        }

        private static double MeanSpeed(RobustLiquid column, int frames, Action play)
        {
            double sum = 0.0;
            for (int frame = 0; frame < frames; frame++)
            {
                play();
                sum += column.Speed() / frames;
            }
            return sum;
        }
    }
}
