using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Spray, foam and bubbles of one liquid (Ihmsen, Akinci, Akinci and Teschner 2012): once a frame they move, and the liquid makes
    /// more. The liquid does not feel them. The same liquid has the same whitewater to the bit, as long as it is stepped in the same
    /// frames.
    /// </summary>
    internal sealed class WhitewaterFlow : IDisposable
    {
        // Of a piece over that of foam on still water: bubbles age half as fast.
        private const double LongestLife = 2.0;

        private static readonly uint[] Zeros = new uint[WhitewaterBuffers.StateSlots];

        private readonly WhitewaterPotentialsPass potentials;
        private readonly WhitewaterMotionPass motion;
        private readonly WhitewaterListPass list;
        private readonly NumberReadback readback;
        private readonly CommandBuffer cmd = new CommandBuffer { name = "Fluid Whitewater" };
        private FluidSolver liquid;
        private int particleChanges;
        private double time, moved;
        private long steps;

        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public WhitewaterFlow(FluidShaderSet shaders)
        {
            foreach (string shortfall in ShaderGroup.Whitewater.Shortfalls(DeviceCapabilities.Query()))
            {
                throw new FluidDeviceException(shortfall);
            }
            potentials = new WhitewaterPotentialsPass(shaders);
            motion = new WhitewaterMotionPass(shaders);
            list = new WhitewaterListPass(shaders);
            readback = new NumberReadback(WhitewaterBuffers.StateSlots, state => Counts = WhitewaterBuffers.Read(state));
        }

        /// <summary>The pieces; null before the first <see cref="Advance"/>.</summary>
        public WhitewaterBuffers Buffers { get; private set; }

        /// <summary>How much there is, as of a few frames ago.</summary>
        public WhitewaterCounts Counts { get; private set; }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => Buffers?.Bytes ?? 0;

        /// <summary>
        /// Brings the whitewater to the liquid's present state. Nothing is done where no time has passed; another liquid, one that was put
        /// in the place of the present, and another capacity begin without any.
        /// </summary>
        /// <param name="solver">The liquid.</param>
        /// <param name="now">Its time since the start [s], rest without steps included.</param>
        /// <param name="settings">What it is to be.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public void Advance(FluidSolver solver, double now, in WhitewaterSettings settings)
        {
            if (solver != liquid || solver.ParticleChanges != particleChanges || now < time || Buffers == null ||
                Buffers.Capacity != settings.Capacity)
            {
                Begin(solver, now, settings.Capacity);
            }
            var duration = (float)(now - time);
            if (!(duration > 0f)) return;
            time = now;
            if (solver.StepCount != steps) moved = now;
            steps = solver.StepCount;
            if (now - moved > LongestLife * settings.FoamLife) return; // on liquid that sleeps all is gone by then
            Buffers.Reserve(solver.ParticleCount);
            cmd.Clear();
            Record(cmd, solver, settings, duration);
            Graphics.ExecuteCommandBuffer(cmd);
        }

        /// <summary>Waits for the GPU and reads how much there is; for tools and tests.</summary>
        public WhitewaterCounts ReadCounts()
        {
            readback.ReadNow(Buffers.State);
            return Counts;
        }

        public void Dispose()
        {
            readback.Dispose();
            cmd.Dispose();
            Buffers?.Dispose();
            Buffers = null;
        }

        private void Begin(FluidSolver solver, double now, int capacity)
        {
            liquid = solver;
            particleChanges = solver.ParticleChanges;
            time = moved = now;
            steps = solver.StepCount;
            Counts = default;
            if (Buffers == null || Buffers.Capacity != capacity)
            {
                Buffers?.Dispose();
                Buffers = null;
                Buffers = new WhitewaterBuffers(capacity);
                return;
            }
            Buffers.State.SetData(Zeros);
            Buffers.DrawArguments.SetData(new uint[] { 0, 1, 0, 0 });
        }

        private void Record(CommandBuffer cmd, FluidSolver solver, in WhitewaterSettings settings, float duration)
        {
            solver.RecordNeighbourSetup(cmd);
            cmd.SetBufferData((GraphicsBuffer)Buffers.State, Zeros, 0, WhitewaterBuffers.FirstOfFrame, WhitewaterBuffers.SlotsOfFrame);
            motion.Record(cmd, solver, Buffers, duration);
            potentials.Record(cmd, solver, Buffers, settings.Amount, duration);
            list.Record(cmd, solver, Buffers, unchecked((int)steps), settings.FoamLife, duration);
            Buffers.Exchange();
            readback.RecordRequest(cmd, Buffers.State);
        }
    }
}
