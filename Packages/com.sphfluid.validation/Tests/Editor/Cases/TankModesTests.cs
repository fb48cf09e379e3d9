using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class TankModesTests
    {
        private const double Length = 3.0, Depth = 0.8, Gravity = 9.81, Wall = -1.2;
        private static readonly TankModes tank = new TankModes(Length, Depth, Gravity, double.PositiveInfinity);

        [Test]
        public void ModesOfALevelAreFound()
        {
            double[] made = { 2e-4, 0.0, -1e-4, 5e-5 }, found = new double[4];
            tank.Measure(TankStates.Below(Wall, Wall + Length, x => Depth + tank.Level(made, x - Wall)), Wall, found);

            for (int n = 0; n < made.Length; n++) Assert.That(found[n], Is.EqualTo(made[n]).Within(2e-7), $"mode {n + 1}");
        }

        [Test]
        public void AWallThatStandsInTheLiquidsPlaceIsNoMode()
        {
            const double Moved = 1e-4;
            var found = new double[6];
            tank.Measure(TankStates.Below(Wall + Moved, Wall + Length, x => Depth * Length / (Length - Moved)), Wall, found, Moved);

            Assert.That(found, Is.All.Zero.Within(1e-3 * Moved));
        }

        [Test]
        public void LiquidThatIsCompressedStandsLowerThanItsMass()
        {
            // gH/c² = 0.1: at the floor the density is 1.1.
            var soft = new TankModes(Length, Depth, Gravity, Math.Sqrt(10.0 * Gravity * Depth));
            double[] found = new double[1], foundSoft = new double[1];
            var state = TankStates.Below(Wall, Wall + Length, x => Depth + tank.Level(new[] { 1e-3 }, x - Wall));
            tank.Measure(state, Wall, found);
            soft.Measure(state, Wall, foundSoft);

            Assert.That(foundSoft[0], Is.EqualTo(found[0] / 1.1).Within(1e-9));
        }

        [Test]
        public void AnAcceleratedTankSwingsAboutThePlaneThatItTiltsTo()
        {
            double[] highest = Enumerable.Range(1, 99).Select(n => tank.Tilted(n, 0.05, Math.PI / tank.Frequency(n))).ToArray();
            foreach (double x in new[] { 0.3, 1.5, 2.6 })
            {
                Assert.That(0.5 * tank.Level(highest, x), Is.EqualTo(0.05 * (x - 0.5 * Length)).Within(5e-4),
                    "the mean of start and highest is the plane");
            }
            Assert.That(tank.Tilted(3, 0.05, 0.0), Is.Zero);
            Obeys(t => tank.Tilted(3, 0.05, t), 3, t => tank.Frequency(3) * tank.Frequency(3) * highest[2] / 2.0);
        }

        [Test]
        public void ADrivenModeIsAPendulumThatTheWallsAccelerationPushes([Values(1, 4, 9)] int n)
        {
            const double Stroke = 0.05, Frequency = 3.0;
            double k = tank.WaveNumber(n);
            Obeys(t => tank.Driven(n, Stroke, Frequency, t), n,
                t => 2.0 * Math.Tanh(k * Depth) / (k * Length) * 0.5 * Stroke * Frequency * Frequency * Math.Cos(Frequency * t));
            Assert.That(tank.Driven(n, Stroke, Frequency, 0.0), Is.Zero);
        }

        [Test]
        public void ALongFlumesWavesAreAsHighAsTheTransferFunctionOfItsPaddleHasThem([Values(0.6, 1.5, 3.0)] double kh)
        {
            // H/S = 2 (cosh 2kH − 1)/(sinh 2kH + 2kH): R. G. Dean and R. A. Dalrymple, Water Wave Mechanics, (6.25).
            const double Place = 2.5;
            var flume = new TankModes(60.0, 1.0, Gravity, double.PositiveInfinity);
            double frequency = flume.FrequencyOf(kh), period = 2.0 * Math.PI / frequency, highest = 0.0, lowest = 0.0;
            for (int i = 0; i <= 60; i++)
            {
                double t = (9.0 + i / 60.0) * period;
                double level = flume.Level(Enumerable.Range(1, 300).Select(n => flume.Driven(n, 1.0, frequency, t)).ToArray(), Place);
                highest = Math.Max(highest, level);
                lowest = Math.Min(lowest, level);
            }
            Assert.That(highest - lowest, Is.EqualTo(2.0 * (Math.Cosh(2.0 * kh) - 1.0) / (Math.Sinh(2.0 * kh) + 2.0 * kh))
                .Within(3).Percent);
        }

        [Test]
        public void ASlowPaddleMakesNoWaves()
        {
            double frequency = 0.02 * tank.Frequency(1), half = Math.PI / frequency;
            Assert.That(Math.Abs(tank.Driven(1, 0.1, frequency, half)), Is.LessThan(1e-4));
        }

        // η″ + ω² η = f by second differences.
        private static void Obeys(Func<double, double> mode, int n, Func<double, double> force)
        {
            const double Step = 1e-3;
            double scale = Math.Abs(force(0.0));
            foreach (double t in new[] { 0.2, 0.9, 2.3 })
            {
                double second = (mode(t + Step) - 2.0 * mode(t) + mode(t - Step)) / (Step * Step);
                Assert.That(second + tank.Frequency(n) * tank.Frequency(n) * mode(t), Is.EqualTo(force(t)).Within(1e-4 * scale),
                    $"t = {t}");
            }
        }
    }
}
