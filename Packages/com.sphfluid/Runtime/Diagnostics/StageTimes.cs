using System;
using System.Collections.Generic;
using Unity.Profiling;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the times of stages are of.</summary>
    internal enum StageClock
    {
        /// <summary>Nothing measures them: a release build.</summary>
        None,
        /// <summary>What the CPU takes to hand the work to the GPU.</summary>
        Cpu,
        /// <summary>What the GPU takes.</summary>
        Gpu,
    }

    /// <summary>
    /// Mean times of the stages a frame, by Unity's recorders of the passes' markers. On the GPU where Unity measures that; where for
    /// several readings in which steps were taken nothing comes, on the CPU; where nothing comes there either, not at all.
    /// </summary>
    internal sealed class StageTimes : IDisposable
    {
        /// <summary>Readings without any sample after which another clock is tried: GPU times come some frames late.</summary>
        public const int Patience = 4;

        // Frames between two readings that are kept; of more the last count.
        private const int Capacity = 128;

        private readonly IReadOnlyList<FluidStage> stages;
        private readonly List<ProfilerRecorder> recorders = new List<ProfilerRecorder>();
        private readonly List<int> stageOf = new List<int>();
        private readonly List<ProfilerRecorderSample> samples = new List<ProfilerRecorderSample>(Capacity);
        private readonly double[] milliseconds;
        private int silent;

        /// <param name="stages">The stages.</param>
        /// <param name="clock">Clock to begin with.</param>
        public StageTimes(IReadOnlyList<FluidStage> stages, StageClock clock)
        {
            this.stages = stages;
            milliseconds = new double[stages.Count];
            Use(clock);
        }

        /// <summary>The first clock to try on this device.</summary>
        public static StageClock Best => SystemInfo.supportsGpuRecorder ? StageClock.Gpu : StageClock.Cpu;

        /// <summary>What the times are of.</summary>
        public StageClock Clock { get; private set; }

        /// <summary>Whether any time has come yet.</summary>
        public bool HasTimes { get; private set; }

        /// <summary>Mean time of a stage a frame [ms], as of the last reading.</summary>
        public double Milliseconds(int stage) => milliseconds[stage];

        /// <summary>Takes in the frames since the last reading.</summary>
        /// <param name="worked">Whether any liquid took steps in them.</param>
        public void Read(bool worked)
        {
            if (Clock == StageClock.None) return;
            Array.Clear(milliseconds, 0, milliseconds.Length);
            bool any = false;
            for (int i = 0; i < recorders.Count; i++)
            {
                recorders[i].CopyTo(samples, true);
                long sum = 0;
                for (int s = 0; s < samples.Count; s++)
                {
                    sum += samples[s].Value;
                    any |= samples[s].Count > 0 && samples[s].Value > 0;
                }
                if (samples.Count > 0) milliseconds[stageOf[i]] += sum * 1e-6 / samples.Count;
            }
            HasTimes |= any;
            silent = any || !worked ? 0 : silent + 1;
            if (silent >= Patience && !HasTimes) Use(Clock == StageClock.Gpu ? StageClock.Cpu : StageClock.None);
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            foreach (ProfilerRecorder recorder in recorders) recorder.Dispose();
            recorders.Clear();
            stageOf.Clear();
        }

        private void Use(StageClock clock)
        {
            Dispose();
            Clock = clock;
            silent = 0;
            if (clock == StageClock.None) return;
            ProfilerRecorderOptions options = ProfilerRecorderOptions.Default | ProfilerRecorderOptions.StartImmediately;
            if (clock == StageClock.Gpu) options |= ProfilerRecorderOptions.GpuRecorder;
            for (int i = 0; i < stages.Count; i++)
            {
                foreach (string pass in stages[i].Passes)
                {
                    recorders.Add(new ProfilerRecorder(ComputeKernel.CreateMarker(pass), Capacity, options));
                    stageOf.Add(i);
                }
            }
        }
    }
}
