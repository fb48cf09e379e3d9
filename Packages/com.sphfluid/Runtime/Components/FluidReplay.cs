using System;
using System.IO;
using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>
    /// Plays what <see cref="FluidRecording"/> wrote: restores the liquid, gives it the times of the recorded frames in place of the
    /// scene's, and compares the state after each. The game brings its objects to where they were, before and in each frame.
    /// </summary>
    public sealed class FluidReplay : IDisposable, IFluidFrames
    {
        private readonly FluidSimulation simulation;
        private readonly Stream stream;
        private readonly byte[] bytes = new byte[FluidFrame.Size];
        private FluidFrame now;
        private bool taken;

        /// <summary>Restores the liquid and begins with the next frame; before the liquid's LateUpdate that is the present one.</summary>
        /// <param name="simulation">A simulation that is neither recorded nor replayed.</param>
        /// <param name="stream">The recording; it stays open.</param>
        /// <exception cref="ArgumentNullException">One is missing.</exception>
        /// <exception cref="InvalidDataException">The liquid could not be restored; the simulation's messages say why, and it goes on as it
        /// was.</exception>
        /// <exception cref="InvalidOperationException">It is recorded or replayed already.</exception>
        public FluidReplay(FluidSimulation simulation, Stream stream)
        {
            if (simulation == null) throw new ArgumentNullException(nameof(simulation));
            this.simulation = simulation;
            this.stream = stream ?? throw new ArgumentNullException(nameof(stream));
            simulation.Attach(this);
            if (!simulation.Restore(stream))
            {
                simulation.Detach(this);
                throw new InvalidDataException("The recording was not restored. " + simulation.StatusMessage);
            }
            simulation.Updated += Compare;
            simulation.Stopped += End;
            IsPlaying = ReadFrame();
        }

        /// <summary>Frames that were played.</summary>
        public int FrameCount { get; private set; }

        /// <summary>
        /// Number of the first frame, from 0 on, after which the liquid was another than the recorded one; −1: none so far.
        /// </summary>
        public int FirstDifference { get; private set; } = -1;

        /// <summary>Whether frames are left. After the last one the liquid goes on with the time of the scene.</summary>
        public bool IsPlaying { get; private set; }

        /// <summary>Whether the recording ends within a frame or with one that was altered: what is behind it is not played.</summary>
        public bool IsDamaged { get; private set; }

        /// <summary>Ends the replay; the liquid goes on with the time of the scene.</summary>
        public void Dispose()
        {
            IsPlaying = false;
            simulation.Updated -= Compare;
            simulation.Stopped -= End;
            simulation.Detach(this);
        }

        FluidFrame IFluidFrames.Take(in FluidFrame frame)
        {
            taken = IsPlaying;
            return IsPlaying ? now : frame;
        }

        private void Compare(FluidSimulation liquid)
        {
            if (!taken) return;
            taken = false;
            if (FirstDifference < 0 && liquid.ComputeStateHash() != now.Hash) FirstDifference = FrameCount;
            FrameCount++;
            IsPlaying = ReadFrame();
        }

        private void End(FluidSimulation liquid) => Dispose();

        private bool ReadFrame()
        {
            int read = 0;
            while (read < bytes.Length)
            {
                int part = stream.Read(bytes, read, bytes.Length - read);
                if (part == 0) break;
                read += part;
            }
            if (read == 0) return false;
            now = MemoryMarshal.Read<FluidFrame>(bytes);
            IsDamaged = read < bytes.Length || now.Check != now.Expected;
            return !IsDamaged;
        }
    }
}
