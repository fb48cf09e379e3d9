using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Made-up statistics over time: a metre of water that falls, splashes and settles, and what can be done to it.</summary>
    internal sealed class StatisticsSeries
    {
        private const int Particles = 8000;

        public FluidSolverSettings Settings = TestSettings.ByRule(new Vector3(1f, 1f, 1f), 0.04f);
        public double RealViscosity = double.NaN;
        public readonly List<FluidStatistics> Statistics = new List<FluidStatistics>();
        public readonly List<FluidCounters> Counters = new List<FluidCounters>();

        /// <summary>Healthy: energy falls from that of 0.4 m of water lifted by 0.3 m, compression of 1 %, noise decays.</summary>
        public static StatisticsSeries Healthy()
        {
            var series = new StatisticsSeries();
            double mass = series.Settings.ParticleMass * Particles;
            for (int i = 0; i < 40; i++)
            {
                long step = 50L * i;
                double time = step * series.Settings.TimeStep, fall = Math.Exp(-3.0 * time);
                double speed = i == 0 ? 0.0 : 1.5 * fall * Math.Abs(Math.Sin(6.0 * time)) + 0.01;
                series.Statistics.Add(new FluidStatistics
                {
                    Time = time,
                    Step = step,
                    ParticleCount = Particles,
                    Listed = Particles,
                    MaxNeighbours = i == 0 ? 32 : 45,
                    MaxCellCount = 90,
                    WallCrowding = 1.5,
                    Clumped = i == 0 ? 0 : Particles / 8,
                    KineticEnergy = 0.5 * mass * speed * speed,
                    PotentialEnergy = mass * 9.81 * (-0.3 + 0.3 * fall) - 0.5 * mass * speed * speed,
                    ElasticEnergy = 0.01 * mass,
                    Momentum = new Vector3(0f, (float)(-mass * speed), 0f),
                    MomentumScale = mass * speed,
                    MaxSpeed = 2.0 * speed,
                    MeanCompression = 0.01,
                    MaxDensityRatio = i == 0 ? 1.02 : 1.06,
                    MinDensityRatio = 0.5,
                    Checkerboard = i < 20 ? 0.3 : 0.9,
                });
                series.Counters.Add(default);
            }
            return series;
        }

        /// <summary>Changes a measurement.</summary>
        public StatisticsSeries At(int index, Func<FluidStatistics, FluidStatistics> change)
        {
            Statistics[index] = change(Statistics[index]);
            return this;
        }

        /// <summary>Changes all measurements from one on.</summary>
        public StatisticsSeries From(int first, Func<FluidStatistics, FluidStatistics> change)
        {
            for (int i = first; i < Statistics.Count; i++) At(i, change);
            return this;
        }

        /// <summary>Changes the guards' counts from one measurement on.</summary>
        public StatisticsSeries Count(int first, FluidCounters counters)
        {
            for (int i = first; i < Counters.Count; i++) Counters[i] = counters;
            return this;
        }

        /// <summary>Changes the constants.</summary>
        public StatisticsSeries With(Func<FluidSolverSettings, FluidSolverSettings> change)
        {
            Settings = change(Settings);
            return this;
        }

        /// <summary>The same motion by the Standard method.</summary>
        public StatisticsSeries OfStandard()
        {
            double before = Settings.TimeStep;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = Settings.DomainSize;
            input.Spacing = Settings.Spacing;
            input.LiquidHeight = Settings.DomainSize.y;
            input.LiquidDepth = 0.5f * Settings.DomainSize.y;
            Settings = FluidRules.Derive(input);
            double ratio = Settings.TimeStep / before;
            return From(0, v => { v.Time *= ratio; return v; });
        }

        public FluidDetectors Detectors() => new FluidDetectors(Settings, RealViscosity);

        /// <summary>The findings of each measurement.</summary>
        public List<IReadOnlyList<FluidFinding>> Run()
        {
            FluidDetectors detectors = Detectors();
            var found = new List<IReadOnlyList<FluidFinding>>();
            for (int i = 0; i < Statistics.Count; i++) found.Add(detectors.Update(Statistics[i], Counters[i]));
            return found;
        }
    }
}
