using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>
    /// Whitewater around a liquid's particles, a part of it in each, moved and drawn in a command buffer: to measure what it costs.
    /// </summary>
    public sealed class MeasuredWhitewater : IDisposable
    {
        // Of a frame at 60 a second.
        private const float Duration = 1f / 60f;

        private readonly WhitewaterBuffers buffers;
        private readonly WhitewaterMotionPass motion;
        private readonly WhitewaterPotentialsPass potentials;
        private readonly WhitewaterListPass list;
        private readonly WhitewaterDrawing drawing;

        /// <summary>Whitewater without any particles yet.</summary>
        /// <param name="shaders">The shaders.</param>
        /// <param name="count">Particles of whitewater.</param>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public MeasuredWhitewater(FluidShaderSet shaders, int count)
        {
            motion = new WhitewaterMotionPass(shaders);
            potentials = new WhitewaterPotentialsPass(shaders);
            list = new WhitewaterListPass(shaders);
            drawing = new WhitewaterDrawing(shaders);
            buffers = new WhitewaterBuffers(count);
        }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => buffers.Bytes;

        /// <summary>Whether it has its particles.</summary>
        public bool IsFilled { get; private set; }

        /// <summary>
        /// Waits for the GPU and puts a particle of whitewater beside each of the liquid's, spread by half a spacing, foam where the motion
        /// finds it to be.
        /// </summary>
        /// <param name="solver">The liquid.</param>
        public void Fill(FluidSolver solver)
        {
            var random = new System.Random(1);
            var particles = new FluidParticle[solver.ParticleCount];
            solver.Particles.GetData(particles);
            var pieces = new float[buffers.Capacity * WhitewaterBuffers.Stride / sizeof(float)];
            for (int i = 0; i < buffers.Capacity; i++)
            {
                Vector3 place = particles[i % particles.Length].Position + solver.Settings.Spacing * Offset(random),
                    speed = particles[i % particles.Length].VelT1;
                float[] piece = { place.x, place.y, place.z, 1e6f, speed.x, speed.y, speed.z,
                    BitConverter.Int32BitsToSingle(random.Next(1 << 28) << 2), 0f, 1f, 0f, 1f };
                Array.Copy(piece, 0, pieces, i * piece.Length, piece.Length);
            }
            buffers.Present.SetData(pieces);
            var state = new uint[WhitewaterBuffers.StateSlots];
            state[0] = (uint)buffers.Capacity;
            buffers.State.SetData(state);
            buffers.Reserve(solver.ParticleCount);
            IsFilled = true;
        }

        /// <summary>Records a frame of whitewater: motion, potentials, list.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver)
        {
            cmd.SetBufferData((GraphicsBuffer)buffers.State, new uint[WhitewaterBuffers.SlotsOfFrame], 0, WhitewaterBuffers.FirstOfFrame,
                WhitewaterBuffers.SlotsOfFrame);
            motion.Record(cmd, solver, buffers, Duration);
            potentials.Record(cmd, solver, buffers, 1f, Duration);
            list.Record(cmd, solver, buffers, 0, 3f, Duration);
            buffers.Exchange();
        }

        /// <summary>Records its drawing into the present render target.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The liquid; its domain is centred on the origin.</param>
        public void Draw(CommandBuffer cmd, FluidSolver solver)
        {
            drawing.Fill(buffers, solver.Settings.Spacing, 1f, Color.white,
                new DrawPlacement(Matrix4x4.identity, solver.Settings.DomainSize, 0f, 0, false), solver.SimulatedTime);
            drawing.Record(cmd);
        }

        /// <summary>Frees the GPU memory.</summary>
        public void Dispose()
        {
            drawing.Dispose();
            buffers.Dispose();
        }

        private static Vector3 Offset(System.Random random) =>
            new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
    }
}
