using System;
using System.Collections.Generic;
using Unity.Profiling;

namespace SphFluid.Validation
{
    /// <summary>
    /// GPU times of the frame and of its blocks by Unity's profiler. They come some frames after the work: <see cref="Collect"/> is
    /// called once a frame of the engine until all are in.
    /// </summary>
    sealed class GpuClock : IDisposable
    {
        const int Capacity = 64;
        const ProfilerRecorderOptions Options = ProfilerRecorderOptions.Default | ProfilerRecorderOptions.GpuRecorder | ProfilerRecorderOptions.StartImmediately;

        readonly List<ProfilerRecorderSample> samples = new List<ProfilerRecorderSample>();
        readonly ProfilerRecorder[] recorders; // the blocks, then the frame
        readonly long[] nanoseconds;
        long frames;

        public GpuClock()
        {
            recorders = new ProfilerRecorder[BenchBlocks.Names.Count + 1];
            nanoseconds = new long[recorders.Length];
            for (int i = 0; i < recorders.Length; i++)
                recorders[i] = new ProfilerRecorder(ComputeKernel.CreateMarker(i < BenchBlocks.Names.Count ? BenchBlocks.Names[i] : BenchBlocks.Frame), Capacity, Options);
        }

        /// <summary>Forgets what came so far.</summary>
        public void Restart()
        {
            Collect(0);
            Array.Clear(nanoseconds, 0, nanoseconds.Length);
            frames = 0;
        }

        /// <summary>Takes in what came since the last call; whether the times of that many benchmark frames are there.</summary>
        public bool Collect(int expectedFrames)
        {
            for (int i = 0; i < recorders.Length; i++)
            {
                recorders[i].CopyTo(samples, true);
                foreach (ProfilerRecorderSample sample in samples)
                {
                    nanoseconds[i] += sample.Value;
                    frames += i == recorders.Length - 1 ? sample.Count : 0;
                }
            }
            return frames >= expectedFrames;
        }

        /// <summary>The times that are in.</summary>
        public BenchTimes Times(int frameCount)
        {
            var blocks = new double[BenchBlocks.Names.Count];
            for (int i = 0; i < blocks.Length; i++)
                blocks[i] = nanoseconds[i] * 1e-6;
            return new BenchTimes(frameCount, nanoseconds[blocks.Length] * 1e-6, blocks);
        }

        public void Dispose()
        {
            for (int i = 0; i < recorders.Length; i++)
                recorders[i].Dispose();
        }
    }
}
