using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Validation
{
    /// <summary>
    /// Streams a sequence at 30 frames a second without drawing it, and jumps about in it. The liquid is a block whose particles swing each
    /// by its own, so that no frame is like another. In play mode only.
    /// </summary>
    internal sealed class PlaybackBench : IDisposable
    {
        public const int Frames = 100, Seeks = 25, UsualParticles = 65536;

        // Fewer frames than there are, so that the files are read all the time; four and more always fit.
        private const int HeldFrames = 12;
        private const double Rate = 30.0;
        private const float Spacing = 0.02f;

        private readonly string folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        private readonly FluidProfile profile;
        private readonly int side;
        private readonly int particles;
        private readonly float captureBefore = Time.captureDeltaTime;
        private GameObject holder;

        public PlaybackBench(FluidShaderSet shaders, int particles)
        {
            this.particles = particles;
            side = Mathf.CeilToInt(Mathf.Pow(particles, 1f / 3f));
            profile = ScriptableObject.CreateInstance<FluidProfile>();
            profile.Shaders = shaders;
            profile.MaxParticles = Math.Max(profile.MaxParticles, particles);
        }

        private Vector3 Domain => (side + 2) * Spacing * Vector3.one;

        /// <summary>Measures; adds a row for frames as they are, and one for particles between them.</summary>
        public IEnumerator Run(ResultTable<PlaybackRow> table, SessionProgress progress)
        {
            Time.captureDeltaTime = 0f;
            progress.Say($"Writing {Frames} frames of {particles} particles.");
            for (IEnumerator writing = Write(); writing.MoveNext();) yield return null;
            foreach (bool interpolates in new[] { false, true })
            {
                var row = new PlaybackRow
                {
                    Mode = interpolates ? "interpolated" : "frames", Particles = particles, Frames = Frames,
                    Seeks = Seeks
                };
                row.FileBytes = Directory.GetFiles(folder).Sum(f => new FileInfo(f).Length);
                yield return Play(row, interpolates);
                table.Add(row);
            }
        }

        public void Dispose()
        {
            Time.captureDeltaTime = captureBefore;
            if (holder != null) Object.DestroyImmediate(holder);
            Object.DestroyImmediate(profile);
            if (Directory.Exists(folder)) Directory.Delete(folder, true);
        }

        private IEnumerator Write()
        {
            var frame = new FluidParticle[particles];
            using (var writer = new FluidSequenceWriter(folder, Domain, Spacing, "bench"))
            {
                for (int f = 0; f < Frames; f++)
                {
                    double time = f / Rate;
                    for (int i = 0; i < particles; i++)
                    {
                        var cell = new Vector3(i % side, i / side % side, i / (side * side)) - 0.5f * (side - 1) * Vector3.one;
                        double phase = 0.37 * i + 5.0 * time;
                        Vector3 swing = Spacing * new Vector3((float)Math.Sin(phase), (float)Math.Cos(phase), 0f);
                        frame[i] = new FluidParticle(Spacing * cell + swing, 5f * new Vector3(swing.y, -swing.x, 0f), (uint)i);
                    }
                    writer.Write(time, frame);
                    yield return null;
                }
            }
        }

        private IEnumerator Play(PlaybackRow row, bool interpolates)
        {
            holder = new GameObject("Playback Bench");
            FluidSimulation simulation = holder.AddComponent<FluidSimulation>();
            (simulation.Profile, simulation.DomainSize, simulation.Spacing, simulation.ColliderLayers) = (profile, Domain, Spacing, 0);
            FluidPlayback playback = holder.AddComponent<FluidPlayback>();
            (playback.Folder, playback.Interpolate, playback.Loop) = (folder, interpolates, FluidPlaybackLoop.Repeat);
            // The file as it is read, the particles as they are shown, and those frames.
            playback.MemoryBudget = Mathf.CeilToInt((particles * (28f + 48f) + HeldFrames * 28f * particles) / (1 << 20)) + 1;
            var meter = holder.AddComponent<PlaybackFrameMeter>();
            while (playback.CurrentFrame < 0)
            {
                if (playback.Problem is FluidMessage problem) throw new FluidDeviceException($"{problem.Text} {problem.Cure}");
                yield return null;
            }
            (row.Budget, row.Memory) = (playback.MemoryBudget, playback.MemoryBytes / (double)(1 << 20));
            yield return Stream(row, meter);
            yield return Jump(row, playback, simulation);
            Object.DestroyImmediate(holder);
        }

        // As many frames as the sequence has, each begun a thirtieth of a second after the one before, or when that is done.
        private static IEnumerator Stream(PlaybackRow row, PlaybackFrameMeter meter)
        {
            meter.Clear();
            var clock = Stopwatch.StartNew();
            double due = 0.0;
            while (meter.Frames < Frames)
            {
                double left = due - clock.Elapsed.TotalSeconds;
                if (left > 0.0) Thread.Sleep(TimeSpan.FromSeconds(left));
                due = Math.Max(due, clock.Elapsed.TotalSeconds) + 1.0 / Rate;
                yield return null;
            }
            row.Rate = Frames / clock.Elapsed.TotalSeconds;
            row.Held = meter.Held;
            row.MainMedian = Median(meter.Milliseconds);
            row.MainMost = meter.Milliseconds.Max();
        }

        private static IEnumerator Jump(PlaybackRow row, FluidPlayback playback, FluidSimulation simulation)
        {
            var random = new System.Random(7);
            var times = new List<double>();
            playback.Pause();
            var clock = new Stopwatch();
            int target = -1;
            double took = -1.0;
            void Look(FluidSimulation _)
            {
                if (took < 0.0 && playback.CurrentFrame == target && !playback.IsBuffering) took = clock.Elapsed.TotalMilliseconds;
            }
            simulation.Updated += Look;
            for (int i = 0; i < Seeks; i++)
            {
                int from = playback.CurrentFrame;
                do target = random.Next(Frames);
                while (Math.Abs(target - from) <= HeldFrames);
                took = -1.0;
                playback.Seek((float)(target / Rate));
                clock.Restart();
                while (took < 0.0) yield return null;
                times.Add(took);
            }
            simulation.Updated -= Look;
            row.SeekMedian = Median(times);
            row.SeekMost = times.Max();
        }

        private static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.OrderBy(v => v).ToArray();
            return sorted[sorted.Length / 2];
        }
    }
}
