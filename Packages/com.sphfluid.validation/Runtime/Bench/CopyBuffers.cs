using System;
using System.Collections.Generic;
using SphFluid.Laboratory;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// Two buffers for the device's copy speed, larger together than a graphics card's cache. A CPU device copies by its library's routine,
    /// which is faster than its kernels can move memory.
    /// </summary>
    internal sealed class CopyBuffers : IDisposable
    {
        /// <summary>Copies of a sample.</summary>
        public const int CopiesPerSample = 8;

        /// <summary>Samples of a measurement; one more before them is thrown away.</summary>
        public const int Samples = 5;

        /// <summary>Bytes that it takes.</summary>
        public const double BytesOfBoth = 2.0 * Bytes;

        private const int Bytes = 64 * 1024 * 1024;
        private const int Stride = 16;

        private readonly List<double> seconds = new List<double>();
        private readonly Vector4[] read = new Vector4[1];
        private GraphicsBuffer source, target;

        public CopyBuffers()
        {
            source = GpuLaboratory.CreateBuffer("CopySource", Bytes / Stride, Stride,
                GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.CopySource);
            target = GpuLaboratory.CreateBuffer("CopyTarget", Bytes / Stride, Stride,
                GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.CopyDestination);
        }

        /// <summary>Bytes read and written a second, by the median of the samples.</summary>
        public double Speed => 2.0 * Bytes / SampleStatistics.Of(seconds).Median;

        public void Record(CommandBuffer cmd) => cmd.CopyBuffer(source, target);

        public void Wait() => target.GetData(read, 0, 0, 1);

        /// <summary>Adds a sample.</summary>
        /// <param name="copy">Time of a copy [ms].</param>
        public void Add(double copy) => seconds.Add(1e-3 * copy);

        public void Dispose()
        {
            GpuLaboratory.Dispose(ref source);
            GpuLaboratory.Dispose(ref target);
        }
    }
}
