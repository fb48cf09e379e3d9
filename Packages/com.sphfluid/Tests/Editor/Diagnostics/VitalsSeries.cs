using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Made-up vitals over time: a metre of water that falls, splashes and settles, and what can be done to it.</summary>
    sealed class VitalsSeries
    {
        const int Particles = 8000;

        public FluidSolverSettings Settings = TestSettings.ByRule(new Vector3(1f, 1f, 1f), 0.04f);
        public double RealViscosity = double.NaN;
        public readonly List<FluidVitals> Vitals = new List<FluidVitals>();
        public readonly List<FluidCounters> Counters = new List<FluidCounters>();

        /// <summary>Healthy: energy falls from that of 0.4 m of water lifted by 0.3 m, compression of 1 %, noise decays.</summary>
        public static VitalsSeries Healthy()
        {
            var series = new VitalsSeries();
            double mass = series.Settings.ParticleMass * Particles;
            for (int i = 0; i < 40; i++)
            {
                long step = 50L * i;
                double time = step * series.Settings.TimeStep, fall = Math.Exp(-3.0 * time);
                double speed = i == 0 ? 0.0 : 1.5 * fall * Math.Abs(Math.Sin(6.0 * time)) + 0.01;
                series.Vitals.Add(new FluidVitals
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
        public VitalsSeries At(int index, Func<FluidVitals, FluidVitals> change)
        {
            Vitals[index] = change(Vitals[index]);
            return this;
        }

        /// <summary>Changes all measurements from one on.</summary>
        public VitalsSeries From(int first, Func<FluidVitals, FluidVitals> change)
        {
            for (int i = first; i < Vitals.Count; i++) At(i, change);
            return this;
        }

        /// <summary>Changes the guards' counts from one measurement on.</summary>
        public VitalsSeries Count(int first, FluidCounters counters)
        {
            for (int i = first; i < Counters.Count; i++) Counters[i] = counters;
            return this;
        }

        /// <summary>Changes the constants.</summary>
        public VitalsSeries With(Func<FluidSolverSettings, FluidSolverSettings> change)
        {
            Settings = change(Settings);
            return this;
        }

        /// <summary>The same motion by the Standard method.</summary>
        public VitalsSeries OfStandard()
        {
            double before = Settings.TimeStep;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = Settings.DomainSize;
            input.Spacing = Settings.Spacing;
            input.LiquidHeight = Settings.DomainSize.y;
            input.LiquidDepth = 0.5f * Settings.DomainSize.y;
            Settings = FluidSolverSettings.FromRules(input);
            double ratio = Settings.TimeStep / before;
            return From(0, v => { v.Time *= ratio; return v; });
        }

        public FluidDetectors Detectors() => new FluidDetectors(Settings, RealViscosity);

        /// <summary>The findings of each measurement.</summary>
        public List<IReadOnlyList<FluidFinding>> Run()
        {
            FluidDetectors detectors = Detectors();
            var found = new List<IReadOnlyList<FluidFinding>>();
            for (int i = 0; i < Vitals.Count; i++) found.Add(detectors.Note(Vitals[i], Counters[i]));
            return found;
        }
    }
}
