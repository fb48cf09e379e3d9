using System;
using System.Collections.Generic;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// GPU time of a liquid's steps, by Unity's profiler, as means over the last frames that had steps. The times come some frames after
    /// the work.
    /// </summary>
    internal sealed class StepTimer : IDisposable
    {
        /// <summary>Frames that the means are taken over.</summary>
        public const int Window = 60;

        private const int Pending = 64;
        private const ProfilerRecorderOptions Options = ProfilerRecorderOptions.Default | ProfilerRecorderOptions.GpuRecorder |
            ProfilerRecorderOptions.StartImmediately;

        [OutlivesPlay("names stay unique")] private static int made;

        private readonly ProfilerMarker marker;
        private readonly List<ProfilerRecorderSample> samples = new List<ProfilerRecorderSample>();
        private readonly Queue<Frame> recorded = new Queue<Frame>(); // whose times are to come
        private readonly Queue<Frame> timed = new Queue<Frame>();
        private ProfilerRecorder recorder;
        private Frame sum;

        /// <summary>Begins to listen.</summary>
        public StepTimer()
        {
            marker = ComputeKernel.CreateMarker($"SPH Fluid Steps {++made}");
            if (IsSupported) recorder = new ProfilerRecorder(marker, Pending, Options);
        }

        /// <summary>Whether the device reports GPU times.</summary>
        public static bool IsSupported => SystemInfo.supportsGpuRecorder;

        /// <summary>Frames in the means, at most <see cref="Window"/>.</summary>
        public int FrameCount => timed.Count;

        /// <summary>GPU time of a frame with steps [ms]; 0 before there is one.</summary>
        public double MillisecondsAFrame => timed.Count == 0 ? 0.0 : 1e-6 * sum.Nanoseconds / timed.Count;

        /// <summary>Steps of such a frame; 0 before there is one.</summary>
        public double StepsAFrame => timed.Count == 0 ? 0.0 : sum.Steps / (double)timed.Count;

        /// <summary>GPU time of a step over the number of particles [ns]; 0 before there is one.</summary>
        public double NanosecondsAParticleStep => sum.ParticleSteps == 0 ? 0.0 : sum.Nanoseconds / (double)sum.ParticleSteps;

        /// <summary>Records the beginning of a frame's steps; <see cref="End"/> closes it.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="steps">Number of steps; none is not timed.</param>
        /// <param name="particles">Number of particles.</param>
        public void Begin(CommandBuffer cmd, int steps, long particles)
        {
            Collect();
            if (steps == 0 || !IsSupported) return;
            while (recorded.Count >= Pending) recorded.Dequeue(); // whose time never came
            recorded.Enqueue(new Frame { Steps = steps, ParticleSteps = steps * particles });
            cmd.BeginSample(marker);
        }

        /// <summary>Records the end of a part of a frame's steps that is submitted for itself.</summary>
        /// <param name="cmd">Command buffer.</param>
        public void EndPart(CommandBuffer cmd) => End(cmd, 1);

        /// <summary>Records the beginning of the next part of the same frame's steps, which are counted with the first.</summary>
        /// <param name="cmd">Command buffer.</param>
        public void BeginPart(CommandBuffer cmd)
        {
            if (!IsSupported) return;
            recorded.Enqueue(default);
            cmd.BeginSample(marker);
        }

        /// <summary>Records the end of a frame's steps.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="steps">Number of steps, as it began.</param>
        public void End(CommandBuffer cmd, int steps)
        {
            if (steps > 0 && IsSupported) cmd.EndSample(marker);
        }

        /// <inheritdoc/>
        public void Dispose() => recorder.Dispose();

        private void Collect()
        {
            if (!IsSupported) return;
            recorder.CopyTo(samples, true);
            foreach (ProfilerRecorderSample sample in samples)
            {
                if (sample.Count == 0 || recorded.Count == 0) continue;
                Frame frame = recorded.Dequeue();
                for (long more = sample.Count; more > 1 && recorded.Count > 0; more--) frame = frame.Plus(recorded.Dequeue(), 1);
                frame.Nanoseconds = sample.Value;
                timed.Enqueue(frame);
                sum = sum.Plus(frame, 1);
                if (timed.Count > Window) sum = sum.Plus(timed.Dequeue(), -1);
            }
        }

        private struct Frame
        {
            public long Nanoseconds, Steps, ParticleSteps;

            public readonly Frame Plus(in Frame other, int times) => new Frame
            {
                Nanoseconds = Nanoseconds + times * other.Nanoseconds,
                Steps = Steps + times * other.Steps,
                ParticleSteps = ParticleSteps + times * other.ParticleSteps,
            };
        }
    }
}
