using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Validation
{
    /// <summary>
    /// Plays a breaking dam by one way: a column of water in the corner of a box falls, runs to the other side and comes back. Frames are
    /// 1/60 s, whatever time they take.
    /// </summary>
    internal sealed class BudgetRun : IDisposable
    {
        /// <summary>Frames that are played: the wave has hit the far wall by then.</summary>
        public const int Frames = 75;

        private const float FrameTime = 1f / 60f;

        // Above what the stiffest way needs to stay calm, 0.001 c R at c = 20 √(2 g · 0.5 m) and R = 2.25 dx: all ways have the same
        // liquid.
        private const float ViscosityOverSpacing = 0.15f; // m/s

        // Enough for runs to part, so little that no way throws its particles up: elastic energy goes with c².
        private const float Jitter = 0.002f;

        private static readonly Vector3 Domain = new Vector3(0.9f, 0.6f, 0.24f), Column = new Vector3(0.3f, 0.5f, 0.24f);

        private readonly BudgetWay way;
        private readonly FluidProfile profile;
        private readonly GameObject holder;
        private readonly FluidSimulation simulation;
        private readonly float captureBefore = Time.captureDeltaTime;

        public BudgetRun(BudgetWay way, int particles, int seed, FluidShaderSet shaders)
        {
            this.way = way;
            profile = ScriptableObject.CreateInstance<FluidProfile>();
            (profile.Shaders, profile.MaxCompression, profile.SoundSpeedRatio) = (shaders, way.MaxCompression, way.SoundSpeedRatio);
            if (way.Substeps > 0) profile.Substeps = way.Substeps;
            holder = new GameObject("Budget Run");
            simulation = holder.AddComponent<FluidSimulation>();
            simulation.PlayOnEnable = false;
            simulation.StopSimulation();
            (simulation.Profile, simulation.DomainSize, simulation.ColliderLayers) = (profile, Domain, 0);
            (simulation.Method, simulation.Seed, simulation.SleepsAtRest) = (way.Method, seed, false);
            simulation.MaxSubstepsPerFrame = way.Method == FluidMethodKind.Automatic ? 8 : 1000;
            if (!double.IsNaN(way.Budget)) simulation.FrameBudget = (float)way.Budget;
            var liquid = new GameObject("Column");
            liquid.transform.SetParent(holder.transform, false);
            liquid.transform.localPosition = 0.5f * (Column - Domain);
            liquid.AddComponent<FluidVolume>().Size = Column;
            simulation.Spacing = simulation.SpacingForParticleCount(particles);
            profile.KinematicViscosity = ViscosityOverSpacing * simulation.Spacing;
            simulation.StartJitter = Jitter;
            Row = new BudgetRow { Way = way, Seed = seed, Spacing = simulation.Spacing };
        }

        /// <summary>What came out.</summary>
        public BudgetRow Row { get; }

        /// <summary>The part that is done.</summary>
        public double Share { get; private set; }

        public IEnumerator Run()
        {
            Time.captureDeltaTime = FrameTime;
            if (!simulation.StartSimulation()) throw new FluidDeviceException(simulation.StatusMessage);
            simulation.BeginTiming();
            var path = new List<Vector3>();
            var particles = new List<FluidParticle>();
            int played = 0;
            simulation.Updated += _ => played++;
            while (played < Frames)
            {
                int before = played;
                yield return null;
                if (played == before) continue;
                simulation.TryReadParticles(particles);
                path.Add(Centre(particles));
                Share = played / (double)Frames;
            }
            Fill(path, particles.Count, played);
        }

        public void Dispose()
        {
            Time.captureDeltaTime = captureBefore;
            Object.DestroyImmediate(holder);
            Object.DestroyImmediate(profile);
        }

        private void Fill(List<Vector3> path, int particles, int played)
        {
            FluidMethodChoice choice = simulation.MethodChoice;
            Row.Path = path.ToArray();
            Row.Particles = particles;
            Row.Method = PlayChoice.NameOf(simulation.ActiveMethod);
            Row.MaxCompression = choice?.Pick.MaxCompression ?? way.MaxCompression;
            Row.Substeps = choice?.Pick.Substeps ?? way.Substeps;
            Row.Predicted = choice?.Pick.MillisecondsAFrame ?? double.NaN;
            Row.CostSource = choice == null ? "" : $"{choice.Pick.CostSource}";
            Row.Milliseconds = simulation.StepMilliseconds;
            Row.StepsAFrame = simulation.StepCount / (double)played;
            Row.RealTimeFactor = simulation.SimulatedTime / (played * (double)FrameTime);
            simulation.EndTiming();
        }

        private static Vector3 Centre(List<FluidParticle> particles)
        {
            double x = 0.0, y = 0.0, z = 0.0;
            foreach (FluidParticle particle in particles)
            {
                x += particle.Position.x;
                y += particle.Position.y;
                z += particle.Position.z;
            }
            int count = Math.Max(1, particles.Count);
            return new Vector3((float)(x / count), (float)(y / count), (float)(z / count));
        }
    }
}
