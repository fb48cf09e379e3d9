using System;
using System.IO;

namespace SphFluid
{
    /// <summary>
    /// Writes a liquid and, from then on, the time of each frame and a hash of the state after it, for <see cref="FluidReplay"/>. Hashes
    /// wait for the GPU: for tools and tests. What the scene's objects do is the game's to record.
    /// </summary>
    public sealed class FluidRecording : IDisposable, IFluidFrames
    {
        private readonly FluidSimulation simulation;
        private readonly Stream stream;
        private FluidFrame now;
        private bool taken;

        /// <summary>Saves the liquid and begins with the next frame; before the liquid's LateUpdate that is the present one.</summary>
        /// <param name="simulation">A liquid that runs and is neither recorded nor replayed.</param>
        /// <param name="stream">Receives the save, and 24 bytes a frame; it stays open.</param>
        /// <exception cref="ArgumentNullException">One is missing.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run, or is recorded or replayed already.</exception>
        public FluidRecording(FluidSimulation simulation, Stream stream)
        {
            if (simulation == null) throw new ArgumentNullException(nameof(simulation));
            this.simulation = simulation;
            this.stream = stream ?? throw new ArgumentNullException(nameof(stream));
            simulation.Attach(this);
            try
            {
                simulation.Save(stream);
            }
            catch
            {
                simulation.Detach(this);
                throw;
            }
            simulation.Updated += Remember;
            simulation.Stopped += End;
        }

        /// <summary>Frames that were written.</summary>
        public int FrameCount { get; private set; }

        /// <summary>Whether frames are still written: until it is disposed, or the liquid is stopped, restored or started again.</summary>
        public bool IsRecording { get; private set; } = true;

        /// <summary>Ends the recording.</summary>
        public void Dispose()
        {
            IsRecording = false;
            simulation.Updated -= Remember;
            simulation.Stopped -= End;
            simulation.Detach(this);
        }

        FluidFrame IFluidFrames.Take(in FluidFrame frame)
        {
            now = frame;
            taken = true;
            return frame;
        }

        private void End(FluidSimulation liquid) => Dispose();

        private void Remember(FluidSimulation liquid)
        {
            if (!taken) return;
            taken = false;
            now.Hash = liquid.ComputeStateHash();
            now.Check = now.Expected;
            stream.Write(now.Bytes);
            FrameCount++;
        }
    }
}
