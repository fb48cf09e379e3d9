using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A buffer and the names that kernels know it by: of "Positions" that is _Positions to read and _PositionsOut to write.
    /// </summary>
    internal sealed class FluidBuffer
    {
        private readonly string name;
        private readonly long plannedBytes;
        private GraphicsBuffer buffer;

        /// <param name="name">Its name.</param>
        /// <param name="count">Number of elements.</param>
        /// <param name="stride">Bytes of an element.</param>
        /// <param name="target">What it is used for.</param>
        /// <param name="isPlanned">Whether only its size is asked for: no memory is taken.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        public FluidBuffer(string name, long count, int stride, GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured,
            bool isPlanned = false)
        {
            this.name = name;
            Id = Shader.PropertyToID("_" + name);
            OutId = Shader.PropertyToID("_" + name + "Out");
            if (isPlanned)
            {
                GpuBuffers.CheckSize(name, count, stride);
                plannedBytes = GpuBuffers.BytesOf(count, stride);
                return;
            }
            buffer = GpuBuffers.Create(name, count, stride, target);
        }

        /// <summary>Bytes that it takes, or would take where it is only planned.</summary>
        public long Bytes => buffer == null ? plannedBytes : GpuBuffers.Size(buffer);

        /// <summary>Property id of the buffer where a kernel reads it, or writes a buffer that has one name only.</summary>
        public int Id { get; }

        /// <summary>Property id where a kernel writes it.</summary>
        public int OutId { get; }

        /// <summary>Number of elements.</summary>
        public int Count => buffer.count;

        /// <summary>The buffer.</summary>
        public static implicit operator GraphicsBuffer(FluidBuffer named) => named.buffer;

        /// <summary>A part of it that begins with an element and has a name of its own.</summary>
        public BufferRange Range(string part, long begin) => new BufferRange(this, part, checked((int)begin));

        /// <summary>Fills the buffer from the CPU, unless it is only planned.</summary>
        /// <param name="data">What it gets.</param>
        /// <param name="first">The first element that it gets.</param>
        public void SetData(Array data, int first = 0) => buffer?.SetData(data, 0, first, data.Length);

        /// <summary>Reads the buffer back, waiting for the GPU.</summary>
        public void GetData(Array data) => buffer.GetData(data);

        /// <summary>Two buffers of equal layout exchange their contents; their names stay.</summary>
        public static void Exchange(FluidBuffer a, FluidBuffer b) => (a.buffer, b.buffer) = (b.buffer, a.buffer);

        /// <summary>A buffer of the same kind for another number of elements.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        internal GraphicsBuffer Another(long count) => GpuBuffers.Create(name, count, buffer.stride);

        /// <summary>Puts a structured buffer in the place of the present one, which the caller gets.</summary>
        internal GraphicsBuffer Replace(GraphicsBuffer other)
        {
            GraphicsBuffer replaced = buffer;
            buffer = other;
            return replaced;
        }

        internal void Dispose() => GpuBuffers.Dispose(ref buffer);
    }
}
