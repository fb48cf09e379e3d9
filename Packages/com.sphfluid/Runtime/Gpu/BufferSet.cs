using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Buffers that are made and released together, each declared once: name, number of elements, bytes of an element.</summary>
    internal abstract class BufferSet : IDisposable
    {
        /// <summary>What buffers of indirect arguments are for; see <see cref="GpuBuffers.CreateArguments"/>.</summary>
        protected const GraphicsBuffer.Target Arguments = GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw;

        private readonly bool isPlanned;
        private readonly List<FluidBuffer> buffers = new List<FluidBuffer>();
        private readonly List<(FluidBuffer buffer, Func<int, long> count)> forEach = new List<(FluidBuffer, Func<int, long>)>();

        /// <param name="isPlanned">Whether only the sizes are asked for: no memory is taken.</param>
        protected BufferSet(bool isPlanned = false) => this.isPlanned = isPlanned;

        /// <summary>Bytes of all buffers, or those that they would take where they are only planned.</summary>
        public long Bytes
        {
            get
            {
                long bytes = 0;
                foreach (FluidBuffer buffer in buffers) bytes += buffer.Bytes;
                return bytes;
            }
        }

        /// <summary>Releases the buffers.</summary>
        public void Dispose()
        {
            foreach (FluidBuffer buffer in buffers) buffer.Dispose();
            buffers.Clear();
        }

        /// <summary>
        /// Makes a buffer that lives as long as the set; when the device has no memory for it, those made before are released.
        /// </summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        protected FluidBuffer Add(string name, long count, int stride, GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured)
        {
            try
            {
                var buffer = new FluidBuffer(name, count, stride, target, isPlanned);
                buffers.Add(buffer);
                return buffer;
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Makes a buffer with an element a particle, which <see cref="Resize"/> makes larger, and some more.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        protected FluidBuffer AddForEach(string name, int particleCount, int stride, long more = 0) =>
            AddFor(name, particleCount, stride, particles => particles + more);

        /// <summary>Makes a buffer whose length goes with the number of particles.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        protected FluidBuffer AddFor(string name, int particleCount, int stride, Func<int, long> count)
        {
            FluidBuffer buffer = Add(name, count(particleCount), stride);
            forEach.Add((buffer, count));
            return buffer;
        }

        /// <summary>
        /// Makes the buffers of <see cref="AddForEach"/> and <see cref="AddFor"/> anew for another number of particles; all of them, or
        /// none where one is too large.
        /// </summary>
        /// <param name="particleCount">Number of particles.</param>
        /// <param name="replaced">Receives what they held, for the caller to copy from and to dispose.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        public virtual void Resize(int particleCount, ICollection<IDisposable> replaced)
        {
            var made = new List<GraphicsBuffer>();
            try
            {
                foreach ((FluidBuffer buffer, Func<int, long> count) in forEach) made.Add(buffer.Another(count(particleCount)));
            }
            catch
            {
                foreach (GraphicsBuffer buffer in made) buffer.Dispose();
                throw;
            }
            for (int i = 0; i < made.Count; i++) replaced.Add(forEach[i].buffer.Replace(made[i]));
        }

        /// <summary>Makes a buffer, or makes it anew where it is too small; what it held is lost then.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size; the others stay.</exception>
        protected void Grow(ref FluidBuffer buffer, string name, long count, int stride,
            GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured)
        {
            if (buffer != null && buffer.Count >= count) return;
            if (buffer != null)
            {
                buffers.Remove(buffer);
                buffer.Dispose();
                buffer = null;
            }
            buffer = new FluidBuffer(name, count, stride, target);
            buffers.Add(buffer);
        }
    }
}
