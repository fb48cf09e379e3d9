using UnityEngine;

namespace SphFluid
{
    /// <summary>Creates named buffers that are checked against the device's limit.</summary>
    internal static class GpuBuffers
    {
        /// <summary>Creates a buffer, structured unless asked otherwise.</summary>
        /// <param name="name">Name shown by frame debuggers and error messages.</param>
        /// <param name="count">Number of elements; zero gives one element, so that the buffer can be bound.</param>
        /// <param name="stride">Bytes of an element.</param>
        /// <param name="target">What it is used for; it settles how shaders declare it.</param>
        /// <returns>The buffer; the caller disposes it.</returns>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        public static GraphicsBuffer Create(string name, long count, int stride,
            GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured)
        {
            CheckSize(name, count, stride);
            return new GraphicsBuffer(target, (int)Elements(count), stride) { name = name };
        }

        /// <summary>Bytes that a buffer takes.</summary>
        /// <param name="count">Number of elements; zero gives one.</param>
        /// <param name="stride">Bytes of an element.</param>
        internal static long BytesOf(long count, int stride) => Elements(count) * stride;

        /// <summary>Checks that the device holds a buffer of a size.</summary>
        /// <exception cref="FluidDeviceException">It has too little memory for it.</exception>
        internal static void CheckSize(string name, long count, int stride)
        {
            long bytes = count * stride;
            if (count > int.MaxValue || bytes > SystemInfo.maxGraphicsBufferSize)
            {
                throw new FluidDeviceException(
                    $"The buffer '{name}' needs {bytes / 1048576.0:F0} MiB ({count} elements of {stride} bytes); " +
                    $"{SystemInfo.graphicsDeviceName} allows {SystemInfo.maxGraphicsBufferSize / 1048576.0:F0} MiB. " +
                    "Use fewer particles, a larger particle spacing or a smaller domain.");
            }
        }

        private static long Elements(long count) => count > 0 ? count : 1;

        /// <summary>
        /// Creates a buffer for the arguments of indirect draws or dispatches, which kernels declare as (RW)ByteAddressBuffer. On Direct3D
        /// 11 such a buffer is never structured: the reference of <see cref="GraphicsBuffer.Target.IndirectArguments"/> gives it views of
        /// 32-bit numbers.
        /// </summary>
        /// <param name="name">Name shown by frame debuggers and error messages.</param>
        /// <param name="count">Number of arguments, uint each.</param>
        /// <returns>The buffer; the caller disposes it.</returns>
        internal static GraphicsBuffer CreateArguments(string name, int count) =>
            Create(name, count, sizeof(uint), GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw);

        /// <summary>Makes a structured buffer anew where there is none or too small a one; its contents are lost then.</summary>
        /// <param name="buffer">The buffer, or null.</param>
        /// <param name="name">Name shown by frame debuggers and error messages.</param>
        /// <param name="count">Least number of elements.</param>
        /// <param name="stride">Bytes of an element.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        internal static void Reserve(ref GraphicsBuffer buffer, string name, long count, int stride)
        {
            if (buffer != null && buffer.count >= count) return;
            Dispose(ref buffer);
            buffer = Create(name, count, stride);
        }

        /// <summary>Bytes of buffers together.</summary>
        /// <param name="buffers">The buffers; null: none.</param>
        /// <returns>Bytes.</returns>
        public static long Size(params GraphicsBuffer[] buffers)
        {
            long bytes = 0;
            foreach (GraphicsBuffer buffer in buffers)
            {
                if (buffer != null) bytes += (long)buffer.count * buffer.stride;
            }

            return bytes;
        }

        /// <summary>Disposes a buffer and forgets it.</summary>
        /// <param name="buffer">The buffer, or null.</param>
        public static void Dispose(ref GraphicsBuffer buffer)
        {
            buffer?.Dispose();
            buffer = null;
        }
    }
}
