using System;
using System.Collections.Generic;
using SphFluid.Laboratory;
using Unity.Profiling;

namespace SphFluid.Validation
{
    /// <summary>
    /// GPU times of the frame and of its blocks by Unity's profiler. They come some frames after the work: <see cref="Collect"/> is
    /// called once a frame of the engine until all are in.
    /// </summary>
    internal sealed class GpuClock : IDisposable
    {
        private const int Capacity = 64;
        private const int SetupIndex = -1; // recorders that count
        private const ProfilerRecorderOptions Options = ProfilerRecorderOptions.Default | ProfilerRecorderOptions.GpuRecorder;

        private readonly List<ProfilerRecorderSample> samples = new List<ProfilerRecorderSample>();
        private readonly List<ProfilerRecorder> recorders = new List<ProfilerRecorder>();
        private readonly List<int> blockOf = new List<int>(); // of each recorder; the frame comes after the blocks
        private readonly List<double> frameMilliseconds = new List<double>();
        private readonly long[] nanoseconds;
        private readonly int blockCount;
        private long frames, setups;

        public GpuClock(IReadOnlyList<BenchBlock> blocks)
        {
            blockCount = blocks.Count;
            nanoseconds = new long[blockCount + 1];
            for (int i = 0; i < blockCount; i++)
            {
                foreach (string marker in blocks[i].Markers) Listen(marker, i);
            }
            foreach (string marker in FrameBlocks.Setup) Listen(marker, SetupIndex);
            Listen(FrameBlocks.Frame, blockCount);
            recorders[recorders.Count - 1].Start();
        }

        /// <summary>
        /// Whether the passes inside a frame are timed too. A device takes the times of a pass by work between the passes, which then is a
        /// part of the frame's time.
        /// </summary>
        public bool TimesPasses
        {
            get => recorders[0].IsRunning;
            set
            {
                for (int i = 0; i < recorders.Count - 1; i++)
                {
                    if (value) recorders[i].Start();
                    else recorders[i].Stop();
                }
            }
        }

        /// <summary>
        /// The time of each benchmark frame that came so far, in their order [ms]; frames of the engine with several count as their sum.
        /// </summary>
        public IReadOnlyList<double> FrameMilliseconds => frameMilliseconds;

        /// <summary>Forgets what came so far.</summary>
        public void Restart()
        {
            Collect(0);
            Array.Clear(nanoseconds, 0, nanoseconds.Length);
            frameMilliseconds.Clear();
            frames = setups = 0;
        }

        /// <summary>Takes in what came since the last call; whether the times of that many benchmark frames are there.</summary>
        public bool Collect(int expectedFrames)
        {
            for (int i = 0; i < recorders.Count; i++)
            {
                recorders[i].CopyTo(samples, true);
                foreach (ProfilerRecorderSample sample in samples)
                {
                    if (blockOf[i] == SetupIndex)
                        setups += sample.Count;
                    else
                        nanoseconds[blockOf[i]] += sample.Value;
                    if (blockOf[i] != blockCount || sample.Count == 0) continue;
                    frames += sample.Count;
                    frameMilliseconds.Add(sample.Value * 1e-6);
                }
            }
            return frames >= expectedFrames;
        }

        /// <summary>The times that are in.</summary>
        public BenchTimes Times(int frameCount)
        {
            var blocks = new double[blockCount];
            for (int i = 0; i < blocks.Length; i++) blocks[i] = nanoseconds[i] * 1e-6;
            return new BenchTimes(frameCount, nanoseconds[blockCount] * 1e-6, blocks, setups);
        }

        public void Dispose()
        {
            foreach (ProfilerRecorder recorder in recorders) recorder.Dispose();
        }

        private void Listen(string marker, int block)
        {
            recorders.Add(new ProfilerRecorder(GpuLaboratory.CreateMarker(marker), Capacity, Options));
            blockOf.Add(block);
        }
    }
}
