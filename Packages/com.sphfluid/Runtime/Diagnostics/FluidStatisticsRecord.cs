using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The records of Shaders/Diagnostics/MeasureStatistics.compute, added up in double precision.</summary>
    internal static class FluidStatisticsRecord
    {
        /// <summary>Vectors of a record; STATISTICS_RECORD in the shader.</summary>
        public const int Size = 7;

        private const int Energies = 0, Momentum = 1, Means = 2, Particles = 3, Places = 4, Largest = 5, Fullest = 6;

        /// <summary>Adds records up.</summary>
        /// <param name="records">The records, <see cref="Size"/> vectors each.</param>
        /// <param name="groups">Number of records.</param>
        /// <param name="moment">What was measured.</param>
        public static FluidStatistics Sum(Vector4[] records, int groups, in FluidMoment moment)
        {
            FluidSolverSettings settings = moment.Settings;
            double mass = settings.ParticleMass, sound = settings.SoundSpeed;
            double nonFinite = Add(records, groups, Particles, 0);
            double removed = Add(records, groups, Places, 3);
            int live = moment.ParticleCount - (int)removed;
            double counted = Math.Max(1.0, live - nonFinite);
            double speedSquares = Add(records, groups, Energies, 3);
            double layer = Add(records, groups, Means, 3);
            return new FluidStatistics
            {
                Time = moment.Time,
                Step = moment.Step,
                ParticleCount = live,
                Removed = (int)removed,
                NonFinite = (int)nonFinite,
                Escaped = (int)Add(records, groups, Particles, 1),
                Clumped = (int)Add(records, groups, Particles, 2),
                Coincident = (int)Add(records, groups, Particles, 3),
                Misplaced = (int)Add(records, groups, Places, 0),
                Listed = (long)Add(records, groups, Places, 1),
                AtWalls = (int)Add(records, groups, Places, 2),
                WallCrowding = layer > 0.0 ? Add(records, groups, Means, 2) / (layer * LayerCount(settings)) : 0.0,
                KineticEnergy = mass * Add(records, groups, Energies, 0),
                PotentialEnergy = mass * Add(records, groups, Energies, 1),
                ElasticEnergy = mass * sound * sound * Add(records, groups, Energies, 2),
                Momentum = new Vector3(
                    (float)(mass * Add(records, groups, Momentum, 0)),
                    (float)(mass * Add(records, groups, Momentum, 1)),
                    (float)(mass * Add(records, groups, Momentum, 2))),
                MomentumScale = mass * Add(records, groups, Momentum, 3),
                MeanCompression = Add(records, groups, Means, 0) / counted,
                Checkerboard = speedSquares > 0.0 ? Add(records, groups, Means, 1) / speedSquares : 0.0,
                MaxSpeed = Maximum(records, groups, Largest, 0),
                MaxDensityRatio = Maximum(records, groups, Largest, 1),
                MinDensityRatio = nonFinite < live ? -Maximum(records, groups, Largest, 2) : 0.0,
                MaxNeighbours = (int)Maximum(records, groups, Largest, 3),
                MaxCellCount = (int)Maximum(records, groups, Fullest, 0),
            };
        }

        // Particles of a layer one spacing thick within R of a point in it, at one a dx²: π κ².
        private static double LayerCount(in FluidSolverSettings settings)
        {
            double ratio = settings.SupportRadius / (double)settings.Spacing;
            return Math.PI * ratio * ratio;
        }

        private static double Add(Vector4[] records, int groups, int vector, int component)
        {
            double sum = 0.0;
            for (int group = 0; group < groups; group++) sum += records[group * Size + vector][component];
            return sum;
        }

        private static double Maximum(Vector4[] records, int groups, int vector, int component)
        {
            float maximum = float.NegativeInfinity;
            for (int group = 0; group < groups; group++) maximum = Math.Max(maximum, records[group * Size + vector][component]);
            return maximum;
        }
    }

    /// <summary>What a measurement measured, as of its recording.</summary>
    internal readonly struct FluidMoment
    {
        public readonly FluidSolverSettings Settings;
        public readonly double Time;
        public readonly long Step;
        public readonly int ParticleCount;
        public readonly bool WorkDone;

        public FluidMoment(FluidSolver solver, bool workDone)
        {
            WorkDone = workDone;
            Settings = solver.Settings;
            Time = solver.SimulatedTime;
            Step = solver.StepCount;
            ParticleCount = solver.ParticleCount;
        }
    }
}
