using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The figures of the manual's page on floating bodies: minutes on a software device, so they run by name only. Tanks are four crates wide.
    /// </summary>
    [Explicit("Takes minutes.")]
    public sealed class FloatingFigures
    {
        const float Spacing = 0.03f, Height = 0.32f, Width = 0.48f;
        const int Across = 64, Deep = 20;

        static readonly Vector3 Crate = new Vector3(Width, Height, Width);

        // Periods of potential flow in this tank, whose level rises as the crate sinks: heave of a box, free surface at constant pressure.
        [TestCase(0.25f)]
        [TestCase(0.5f)]
        [TestCase(0.75f)]
        public void DraughtAndHeaveOfACrate(float ratio)
        {
            using (var tank = new FloatingTank(Spacing, Across, Deep, Crate, ratio, Height * (0.6f - ratio), Quaternion.identity))
            {
                tank.Play(3.5);
                List<double> crossings = Crossings(tank.States.Select(s => (double)s.Centre.y).ToList(), tank.Late(1.0, s => s.Centre.y));
                double period = 2.0 * (crossings[2] - crossings[0]) / 2.0;
                TestContext.WriteLine($"{tank.Figures(1.0)}, heave period {period:f3} s, crossings {string.Join(", ", crossings.Take(6).Select(t => t.ToString("f3")))}");
                Assert.That(tank.Draught(1.0), Is.EqualTo(ratio).Within(Math.Max(0.05 * ratio, 0.3 * Spacing / Height)));
            }
        }

        [TestCase(0.05f)]
        [TestCase(0.1f)]
        public void ALightCrateLiesCalm(float ratio)
        {
            using (var tank = new FloatingTank(0.06f, 24, 10, 0.3f * new Vector3(1.5f, 1f, 1.5f), ratio, 0.3f * (0.55f - ratio), Quaternion.Euler(5f, 0f, 3f)))
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
                FloatingMass mass = tank.Body.Mass;
                tank.Body.Mass = new FloatingMass(float.PositiveInfinity, Vector3.positiveInfinity, Vector3.zero) { FreeX = mass.FreeX, FreeY = mass.FreeY, FreeZ = mass.FreeZ };
                tank.Play(3.0);
                double force = tank.Late(1.5, s => s.Impulse.y / s.Time) / tank.Buoyancy;
                TestContext.WriteLine($"force over buoyancy {force:f4} over the last 1.5 s, {tank.Late(0.5, s => s.Impulse.y / s.Time) / tank.Buoyancy:f4} over the last 0.5 s, moved {tank.States.Last().Centre.y + 0.5f} m");
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
                    above += tank.States[i].Centre.y - 0.5f * tank.Size.y > tank.Level && !(tank.States[i - 1].Centre.y - 0.5f * tank.Size.y > tank.Level) ? 1 : 0;
                TestContext.WriteLine($"{tank.Figures(1.0)}, highest {tank.States.Max(s => s.Centre.y) - tank.Level:f3} m above the level, its underside out of the water {above} times");
                Assert.That(above, Is.LessThanOrEqualTo(1));
                Assert.That(tank.States.Max(s => s.Centre.y), Is.GreaterThan(rest + 0.05 * tank.Size.y));
                Assert.That(tank.Draught(1.0), Is.EqualTo(0.2).Within(0.3 * 0.04 / 0.2));
            }
        }

        // Times at which a series passes a value, by straight lines between frames [s].
        static List<double> Crossings(IReadOnlyList<double> series, double value)
        {
            var times = new List<double>();
            for (int i = 1; i < series.Count; i++)
            {
                double before = series[i - 1] - value, after = series[i] - value;
                if (before * after < 0.0) times.Add((i + before / (before - after)) * FloatingTank.FrameTime);
            }
            return times;
        }
    }
}
