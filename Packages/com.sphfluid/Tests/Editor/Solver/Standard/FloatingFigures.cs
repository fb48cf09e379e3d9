using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The figures of the manual's page on floating bodies: minutes on a software device, so they run by name only. Tanks are four crates
    /// wide.
    /// </summary>
    [Explicit("Takes minutes.")]
    public sealed class FloatingFigures
    {
        private const float Spacing = 0.03f, Height = 0.32f, Width = 0.48f;
        private const int Across = 64, Deep = 20;

        private static readonly Vector3 Crate = new Vector3(Width, Height, Width);

        [TestCase(0.25f)]
        [TestCase(0.5f)]
        [TestCase(0.75f)]
        public void DraughtOfACrate(float ratio)
        {
            using (var tank = new FloatingTank(Spacing, Across, Deep, Crate, ratio, Height * (0.52f - ratio), Quaternion.identity))
            {
                tank.Play(3.0);
                TestContext.WriteLine(tank.Figures(1.0));
                Assert.That(tank.Draught(1.0), Is.EqualTo(ratio).Within(Math.Max(0.05 * ratio, 0.3 * Spacing / Height)));
            }
        }

        // Periods of potential flow about the box in this tank, whose surface has no pressure and rises by what the box displaces: the
        // added mass is 34.0, 37.0 and 39.7 kg by finite differences of 2 cm. The crate is held until the water is calm and let go above
        // its draught.
        [TestCase(0.25f, 0.926)]
        [TestCase(0.5f, 1.100)]
        [TestCase(0.75f, 1.247)]
        public void HeaveOfACrate(float ratio, double period)
        {
            using (var tank = new FloatingTank(Spacing, Across, Deep, Crate, ratio, Height * (0.62f - ratio), Quaternion.identity))
            {
                FloatingMass free = tank.Body.Mass;
                tank.Hold();
                tank.Play(1.0);
                int held = tank.States.Count;
                tank.Body.Mass = free;
                tank.Play(1.6);
                List<double> heights = Smooth(tank.States.Skip(held).Select(s => (double)s.Centre.y).ToList());
                int lowest = Extreme(heights, 0, (int)(0.8 * period / FloatingTank.FrameTime), -1.0);
                int highest = Extreme(heights, lowest, heights.Count - 1, 1.0);
                double found = 2.0 * lowest * FloatingTank.FrameTime; // later the waves that it made have a part in it
                TestContext.WriteLine(
                    $"{tank.Figures(0.5)}, lowest {lowest * FloatingTank.FrameTime:f3} s after the release at {heights[lowest]:f4} m, " +
                    $"highest after {highest * FloatingTank.FrameTime:f3} s at {heights[highest]:f4} m: " +
                    $"period {found:f3} s, of potential flow {period:f3} s");
                Assert.That(found, Is.EqualTo(period).Within(0.12 * period));
            }
        }

        [TestCase(0.05f)]
        [TestCase(0.1f)]
        public void ALightCrateLiesCalm(float ratio)
        {
            using (var tank = new FloatingTank(0.06f, 24, 10, 0.3f * new Vector3(1.5f, 1f, 1.5f), ratio, 0.3f * (0.55f - ratio),
                Quaternion.Euler(5f, 0f, 3f)))
            {
                tank.Play(3.0);
                TestContext.WriteLine(tank.Figures(1.0));
                Assert.That(tank.Draught(1.0), Is.EqualTo(ratio).Within(0.3 * 0.06 / 0.3));
                Assert.That(tank.Speed(1.0), Is.LessThan(0.05));
            }
        }

        // The domain's faces do not hold bodies: it falls through the floor, sunk.
        [TestCase(2f)]
        [TestCase(10f)]
        public void AHeavyCrateSinksSlowerThanItFalls(float ratio)
        {
            using (var tank = new FloatingTank(0.06f, 24, 16, 0.3f * new Vector3(1.5f, 1f, 1.5f), ratio, 0f, Quaternion.Euler(5f, 0f, 3f)))
            {
                tank.Play(0.4);
                FloatingState end = tank.States.Last();
                float fall = 0.5f * 9.81f * 0.16f;
                TestContext.WriteLine($"{tank.Figures(0.1)}, speed {end.Velocity}, sunk {-end.Centre.y} m of {fall} m in air");
                Assert.That(end.Centre.y, Is.LessThan(-0.1f).And.GreaterThan(-fall));
                Assert.That(tank.Solver.ReadCountersNow().NonFinite, Is.Zero);
            }
        }

        [Test]
        public void WaterCarriesAHeldBoxByItsBuoyancy()
        {
            using (var tank = new FloatingTank(0.04f, 30, 24, new Vector3(0.4f, 0.32f, 0.4f), 1f, -0.5f, Quaternion.identity))
            {
                tank.Hold();
                tank.Play(3.0);
                double force = tank.Late(1.5, s => s.Impulse.y / s.Time) / tank.Buoyancy;
                TestContext.WriteLine(
                    $"force over buoyancy {force:f4} over the last 1.5 s, {tank.Late(0.5, s => s.Impulse.y / s.Time) / tank.Buoyancy:f4} " +
                    $"over the last 0.5 s, moved {tank.States.Last().Centre.y + 0.5f} m");
                Assert.That(force, Is.EqualTo(1.0).Within(0.03));
            }
        }

        [Test]
        public void ACorkBreaksTheSurfaceOnce()
        {
            using (var tank = new FloatingTank(0.04f, 36, 24, new Vector3(0.24f, 0.2f, 0.24f), 0.2f, -0.6f, Quaternion.Euler(3f, 0f, 2f)))
            {
                tank.Play(4.0);
                double rest = tank.Late(1.0, s => s.Centre.y);
                int above = 0;
                for (int i = 1; i < tank.States.Count; i++)
                {
                    above += tank.States[i].Centre.y - 0.5f * tank.Size.y > tank.Level &&
                        !(tank.States[i - 1].Centre.y - 0.5f * tank.Size.y > tank.Level) ? 1 : 0;
                }
                TestContext.WriteLine(
                    $"{tank.Figures(1.0)}, highest {tank.States.Max(s => s.Centre.y) - tank.Level:f3} m above the level, its underside " +
                    $"out of the water {above} times");
                Assert.That(above, Is.LessThanOrEqualTo(1));
                Assert.That(tank.States.Max(s => s.Centre.y), Is.GreaterThan(rest + 0.05 * tank.Size.y));
                Assert.That(tank.Draught(1.0), Is.EqualTo(0.2).Within(0.3 * 0.04 / 0.2));
            }
        }

        // Means of five frames.
        private static List<double> Smooth(IReadOnlyList<double> series) =>
            Enumerable.Range(0, series.Count)
                .Select(i => Enumerable.Range(i - 2, 5).Where(k => k >= 0 && k < series.Count).Average(k => series[k])).ToList();

        private static int Extreme(IReadOnlyList<double> series, int from, int to, double sign) =>
            Enumerable.Range(from, Math.Min(to, series.Count - 1) - from + 1).OrderByDescending(i => sign * series[i]).First();
    }
}
