using System;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>A fixed number of iterations is a spring whose constant is known.</summary>
    public sealed class RobustStiffnessTests
    {
        [TestCase(0.01f, 1)]
        [TestCase(0.02f, 4)]
        public void AColumnIsCompressedAsTheIterationsSay(float timeStep, int iterations) => Check(timeStep, iterations, 10);

        [TestCase(0.01f, 1)]
        [TestCase(0.02f, 4)]
        [TestCase(0.02f, 8)]
        [Explicit("The table of the paper Robust: half a minute.")]
        public void SoIsOneOfTwentyLayers(float timeStep, int iterations) => Check(timeStep, iterations, 20);

        private static void Check(float timeStep, int iterations, int layers)
        {
            using (RobustLiquid column = RobustLiquid.Column(timeStep, iterations, layers))
            {
                double expected = 0.5 / Math.Pow(RobustRules.EffectiveSoundSpeed(column.Settings, timeStep, iterations), 2.0);
                double compression = Settle(column, timeStep, out double speed);
                TestContext.Out
                    .WriteLine($"compression {compression:G4} for {expected:G4}, height {column.Height():0.000}, speed {speed:G3}");
                Assert.That(compression, Is.EqualTo(expected).Within(10).Percent);
                Assert.That(speed, Is.LessThan(0.03));
            }
        }

        [Test]
        public void ShortStepsHaveTheStiffnessOfTheCompliance()
        {
            const float TimeStep = 0.005f, SoundSpeed = 5f;
            using (RobustLiquid column = RobustLiquid.Column(TimeStep, 2, 9, SoundSpeed))
            {
                double total = RobustRules.EffectiveSoundSpeed(column.Settings, TimeStep, 2);
                Assert.That(total, Is.LessThan(SoundSpeed));
                double compression = Settle(column, TimeStep, out double speed);
                TestContext.Out
                    .WriteLine(
                        $"c {SoundSpeed}, total {total:G4}: compression {compression:G4} for {0.5 / (total * total):G4}, speed {speed:G3}");
                Assert.That(compression, Is.EqualTo(0.5 / (total * total)).Within(10).Percent);
            }
        }

        // Damped for 0.7 √(H/g), then free: the means of the last 1.4 of 3.5.
        private static double Settle(RobustLiquid column, float timeStep, out double speed)
        {
            int frame = Math.Max(1, (int)Math.Round(0.1 / timeStep));
            double compression = 0.0;
            speed = 0.0;
            for (int i = 0; i < 35; i++)
            {
                column.Frame(frame);
                if (i < 7) column.Damp(0.135f);
                if (i < 21) continue;
                compression += column.Compression() / 14.0;
                speed += column.Speed() / 14.0;
            }
            return compression;
        }
    }
}
