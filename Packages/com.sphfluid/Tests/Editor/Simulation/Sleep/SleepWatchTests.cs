using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>When a liquid counts as resting: samples go in, and the watch says when it sleeps.</summary>
    public sealed class SleepWatchTests
    {
        private const double Frame = 1.0 / 60.0;
        private const float Spacing = 0.025f;

        private int keepings, forgotten;

        [SetUp]
        public void SetUp() => keepings = forgotten = 0;

        [Test]
        public void LiquidThatRestsSleepsAfterItsLongestPeriod()
        {
            FluidSolverSettings settings = Settings(new Vector3(0f, -9.81f, 0f));
            var watch = new SleepWatch(settings, 0.18);
            double time = TimeToSleep(watch, _ => 0.01f, _ => 0.0005f);
            double period = LiquidPotential.LongestPeriod(settings, 0.18);
            Assert.That(period, Is.EqualTo(2.76).Within(0.02), "ω² = g k tanh(k D), k = π/1.8 m");
            Assert.That(time, Is.InRange(period, 1.25 * period + 8.0 * Frame));
            Assert.That(keepings, Is.EqualTo(1));
            watch.Wake();
            Assert.That(watch.IsAsleep, Is.False);
            Assert.That(TimeToSleep(watch, _ => 0.01f, _ => 0.0005f), Is.InRange(period, 1.25 * period + 8.0 * Frame), "it rests anew");
        }

        [Test]
        public void ASloshingWaveDoesNotSleepAtItsTurningPoints()
        {
            FluidSolverSettings settings = Settings(new Vector3(0f, -9.81f, 0f));
            double rate = 2.0 * Math.PI / LiquidPotential.LongestPeriod(settings, 0.18);
            const float reach = 0.02f; // m, there and back: speeds of 0.05 m/s at most
            float last = (float)(reach * rate);
            Assert.That(last, Is.LessThan(0.09f), "slow enough for the watch to look at places");
            Assert.That(TimeToSleep(new SleepWatch(settings, 0.18), t => (float)(reach * rate * Math.Abs(Math.Sin(rate * t))),
                t => (float)Math.Abs(reach * Math.Cos(rate * t) - reach * Math.Cos(rate * Kept))), Is.NaN);
            Assert.That(keepings, Is.GreaterThan(10));
        }

        [Test]
        public void LiquidThatCreepsDoesNotSleep()
        {
            Assert.That(TimeToSleep(Watch(), _ => 0.003f, t => (float)(0.003 * (t - Kept))), Is.NaN, "3 mm/s");
            Assert.That(TimeToSleep(Watch(), _ => 0.003f, t => (float)Math.Abs(0.001 * Math.Sin(5.0 * t))), Is.Not.NaN,
                "noise on the spot");
            Assert.That(TimeToSleep(Watch(), _ => 0.0005f, t => (float)(0.0005 * (t - Kept))), Is.Not.NaN,
                "half a millimetre a second in water");
            FluidSolverSettings honey = Settings(new Vector3(0f, -9.81f, 0f), 0.05f);
            Assert.That(TimeToSleep(new SleepWatch(honey, 0.18), _ => 0.0005f, t => (float)(0.0005 * (t - Kept))), Is.NaN, "and in honey");
            Assert.That(TimeToSleep(new SleepWatch(honey, 0.18), _ => 0f, _ => 0f), Is.Not.NaN);
        }

        [Test]
        public void AFewThatFindABetterPlaceKeepNothingAwakeAndAStreamDoes()
        {
            Func<double, float> still = t => 0.002f * (float)Math.Sqrt((t - Kept) / 3.0);
            Assert.That(TimeToSleep(Watch(), _ => 0.1f, t => 0.01f * (float)Math.Sqrt((t - Kept) / 3.0), still), Is.Not.NaN,
                "0.4 dx in 3 s");
            Assert.That(TimeToSleep(Watch(), _ => 0.1f, t => 0.01f * (float)(t - Kept), still), Is.NaN, "0.4 dx a second");
            Assert.That(TimeToSleep(Watch(), _ => 0.1f, t => 0.006f * (float)(t - Kept) / 3f, t => 0.006f * (float)(t - Kept) / 3f),
                Is.NaN, "all go");
        }

        [Test]
        public void OneThatTremblesKeepsNothingAwakeAndADropDoes()
        {
            Func<double, float> falls = t => (float)Math.Min(0.5, 0.5 * 9.81 * (t % 2.0) * (t % 2.0)); // a drop every 2 s
            Assert.That(TimeToSleep(Watch(), _ => 0.001f, _ => 0f, fastest: _ => 0.5f), Is.Not.NaN, "in its place");
            Assert.That(TimeToSleep(Watch(), _ => 0.001f, _ => 0f, fastest: _ => 0.5f, farthest: falls), Is.NaN);
            Assert.That(forgotten, Is.Zero);
            Assert.That(TimeToSleep(Watch(), t => t % 2.0 < Frame ? 0.5f : 0.001f, _ => 0f), Is.NaN, "many at once");
            Assert.That(forgotten, Is.Positive);
            Assert.That(TimeToSleep(Watch(), _ => 0.001f, _ => 0f, fastest: _ => float.PositiveInfinity), Is.NaN, "not a number");
        }

        [Test]
        public void WithoutForcesNothingSleeps()
        {
            Assert.That(TimeToSleep(new SleepWatch(Settings(Vector3.zero), 0.1), _ => 0f, _ => 0f), Is.NaN);
        }

        [Test]
        public void ABodyForceHasAPeriodOfItsOwn()
        {
            FluidSolverSettings settings = Settings(Vector3.zero);
            settings.BodyForce = new FluidBodyForce { RateSquared = new Vector3(4f, 1f, -2f) };
            Assert.That(LiquidPotential.LongestPeriod(settings, 0.1), Is.EqualTo(2.0 * Math.PI).Within(1e-9));
            Assert.That(LiquidPotential.Acceleration(settings), Is.EqualTo(Math.Sqrt(3.6 * 3.6 + 0.6 * 0.6 + 0.8 * 0.8)).Within(1e-6));
        }

        private double Kept { get; set; }

        // Samples are three frames old, as in a running simulation; within a minute.
        private double TimeToSleep(SleepWatch watch, Func<double, float> speed, Func<double, float> distance,
            Func<double, float> half = null, Func<double, float> fastest = null, Func<double, float> farthest = null)
        {
            var samples = new SpeedSample[3];
            for (int i = 0; i < 3; i++) samples[i].Bulk = 1f;
            int kept = 0;
            for (int frame = 0; frame < 3600; frame++)
            {
                double time = frame * Frame;
                watch.AddSample(samples[frame % 3], Frame, () => Keep(ref kept, time), () => Forget(ref kept));
                if (watch.IsAsleep) return time;
                samples[frame % 3] = new SpeedSample
                {
                    Bulk = speed(time),
                    Present = (fastest ?? speed)(time),
                    HalfDistance = kept != 0 ? (half ?? distance)(time) : 0f,
                    Distance = kept != 0 ? distance(time) : 0f,
                    Farthest = kept == 0 ? 0f : farthest?.Invoke(time) ?? 2f * distance(time),
                    Kept = kept,
                };
            }
            return double.NaN;
        }

        private int Keep(ref int kept, double time)
        {
            Kept = time;
            return kept = ++keepings;
        }

        private void Forget(ref int kept)
        {
            forgotten++;
            kept = 0;
        }

        private static SleepWatch Watch() => new SleepWatch(Settings(new Vector3(0f, -9.81f, 0f)), 0.18);

        private static FluidSolverSettings Settings(Vector3 gravity, float viscosity = 1e-6f)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = new Vector3(1.8f, 1.2f, 0.8f);
            input.Spacing = Spacing;
            input.LiquidHeight = 0.8f;
            input.LiquidDepth = 0.18f;
            input.Gravity = gravity;
            input.KinematicViscosity = viscosity;
            return FluidRules.Derive(input);
        }
    }
}
