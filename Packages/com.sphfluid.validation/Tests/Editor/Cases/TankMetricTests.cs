using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The metrics of levels in tanks on linear waves and on others.</summary>
    public sealed class TankMetricTests
    {
        private const double Length = 4.0, Depth = 1.0, Gravity = 9.81, Wall = -2.3, Floor = -1.2, WaveNumber = 1.5, Small = 1e-4;
        private const int Modes = 25;
        private const string HeightName = "height of the waves over the linear ones' − 1";
        private static readonly TankModes tank = new TankModes(Length, Depth, Gravity, double.PositiveInfinity);
        private static readonly double frequency = tank.FrequencyOf(WaveNumber);

        [Test]
        public void AnAcceleratedTanksLinearWavesHaveNoError()
        {
            AcceleratedTankMetric metric = Accelerated(1.0, 0.0);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new AcceleratedTankCase().ErrorName));
            foreach (CaseError error in metric.Evaluate())
            {
                if (error.Name != AcceleratedTankMetric.LeftName) Assert.That(error.Value, Is.Zero.Within(1e-3), error.Name);
            }
            IReadOnlyList<CaseSeries> series = metric.Series();
            Assert.That(series[1].Y, Is.EqualTo(series[0].Y).Within(2e-3));
            Assert.That(series[3].Y, Is.EqualTo(series[2].Y).Within(2e-3));
            Assert.That(series[3].Y.Max(), Is.InRange(1.5, 2.1), "it overshoots to about twice the plane's height");
        }

        [Test]
        public void LevelsThatAreTooHighAndTheSecondOrderAreToldApart()
        {
            AcceleratedTankMetric metric = Accelerated(1.1, 0.25);

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(0.1).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "slope that it swings about over a/g − 1"), Is.EqualTo(0.1).Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "first mode's period, T/T_exact − 1"), Is.Zero.Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, "second mode over the first"), Is.EqualTo(0.25).Within(1e-3));
        }

        [Test]
        public void WhatMovesBesideTheWavesIsToldApart()
        {
            double rms = RootMeanSquareSpeed();
            AcceleratedTankMetric metric = Accelerated(1.0, 0.0, t => t < 1.99 * Period ? 0.5 * rms : 0.25 * rms);

            double moves = WallCaseStates.Named(metric, AcceleratedTankMetric.BesideName);
            Assert.That(WallCaseStates.Named(metric, AcceleratedTankMetric.LeftName), Is.EqualTo(0.25).Within(1e-2));
            Assert.That(moves, Is.EqualTo(0.25).Within(0.02), "half the waves' speed");
            Assert.That(metric.Evaluate()[0].Value, Is.Zero.Within(1e-3), "levels");
        }

        [Test]
        public void APaddlesLinearWavesHaveNoError()
        {
            PaddleMetric metric = Driven(1.0, 0.0);

            Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(new PaddleCase().ErrorName));
            for (int i = 0; i < 3; i++) Assert.That(metric.Evaluate()[i].Value, Is.Zero.Within(1e-3), metric.Evaluate()[i].Name);
            Assert.That(WallCaseStates.Named(metric, "waves late, in periods"), Is.Zero.Within(1e-3));
            Assert.That(WallCaseStates.Named(metric, HeightName), Is.Zero.Within(1e-3));
        }

        [Test]
        public void WavesThatAreTooHighOrLateAreFound()
        {
            PaddleMetric high = Driven(1.2, 0.0), late = Driven(1.0, 0.05);

            Assert.That(high.Evaluate()[0].Value, Is.EqualTo(0.2).Within(1e-3));
            Assert.That(WallCaseStates.Named(late, "waves late, in periods"), Is.EqualTo(0.05).Within(4e-3), "not all is even yet");
            Assert.That(late.Evaluate()[0].Value, Is.GreaterThan(0.2));
            Assert.That(WallCaseStates.Named(high, HeightName), Is.EqualTo(0.2).Within(1e-3));
        }

        [Test]
        public void AShortRunHasNoEvenWaves() => Assert.That(WallCaseStates.Named(Driven(1.0, 0.0, 2.0), "waves late, in periods"), Is.NaN);

        [Test]
        public void ATankThatSwingsFarTooFastFails() => Assert.That(() => Accelerated(1.0, 0.0, pace: 2.7).Evaluate(),
            Throws.TypeOf<SearchBoundException>().With.Message.StartsWith(new AcceleratedTankCase().Name + ": the frequency"));

        private static double Period => 2.0 * Math.PI / tank.Frequency(1);

        // beside: speed across the tank [m/s] at a time.
        private static AcceleratedTankMetric Accelerated(double factor, double second, Func<double, double> beside = null,
            double pace = 1.0)
        {
            var metric = new AcceleratedTankMetric(tank, Wall, Floor, Small);
            double length = (AcceleratedTankMetric.JudgedPeriods + 1.0) * Period, step = Period / 40.0;
            for (double t = 0.0; t < length + 0.5 * step; t += step)
            {
                double[] modes = Enumerable.Range(1, 7).Select(n => factor * tank.Tilted(n, Small, pace * t)).ToArray();
                modes[1] = second * modes[0];
                double across = beside?.Invoke(t) ?? 0.0;
                metric.Sample(t, TankStates.Below(Wall, Wall + Length, x => Depth + tank.Level(modes, x - Wall), at =>
                {
                    Vector3 v = VelocityOf(at, t, factor);
                    v.z = (float)across;
                    return v;
                }));
            }
            return metric;
        }

        // Linear waves: η′ (−sin kx cosh ky, cos kx sinh ky)/sinh kH.
        private static Vector3 VelocityOf(Vector3 at, double time, double factor)
        {
            double vx = 0.0, vy = 0.0;
            for (int n = 1; n <= 7; n += 2)
            {
                double k = tank.WaveNumber(n), rise = (tank.Tilted(n, Small, time + 1e-4) -
                    tank.Tilted(n, Small, time - 1e-4)) / 2e-4 * factor / Math.Sinh(k * Depth);
                vx -= rise * Math.Sin(k * (at.x - Wall)) * Math.Cosh(k * (at.y - Floor));
                vy += rise * Math.Cos(k * (at.x - Wall)) * Math.Sinh(k * (at.y - Floor));
            }
            return new Vector3((float)vx, (float)vy, 0f);
        }

        private static double RootMeanSquareSpeed()
        {
            double sum = 0.0;
            for (int i = 0; i < 40; i++)
            {
                double t = Period * (1.0 + i / 40.0);
                FluidSnapshot state = TankStates.Below(Wall, Wall + Length, x => Depth, at => VelocityOf(at, t, 1.0));
                sum += state.Velocities.Average(v => v.sqrMagnitude) / 40.0;
            }
            return Math.Sqrt(sum);
        }

        private static PaddleMetric Driven(double factor, double late, double periods = 2.5)
        {
            var metric = new PaddleMetric(tank, Wall, Small, WaveNumber);
            for (int i = 0; i <= 20 * periods; i++)
            {
                double t = 2.0 * Math.PI / frequency * i / 20.0, earlier = Math.Max(0.0, t - late * 2.0 * Math.PI / frequency);
                double[] modes = Enumerable.Range(1, Modes).Select(n => factor * tank.Driven(n, Small, frequency, earlier)).ToArray();
                double moved = 0.5 * Small * (1.0 - Math.Cos(frequency * t)), mean = Depth * moved / Length;
                metric.Sample(t, TankStates.Below(Wall + moved, Wall + Length, x => Depth + mean + tank.Level(modes, x - Wall)));
            }
            return metric;
        }
    }
}
