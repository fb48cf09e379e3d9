using Unity.Profiling;
using UnityEngine;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: buffers as the product makes them, its profiler markers and its count of dispatches.</summary>
    public static class GpuLaboratory
    {
        /// <summary>Dispatches recorded by all kernels since the program started; only differences say something.</summary>
        public static long DispatchesRecorded => ComputeKernel.DispatchesRecorded;

        /// <summary>A profiler marker that measures GPU time where the device can.</summary>
        /// <param name="name">Name of the block.</param>
        /// <returns>The marker.</returns>
        public static ProfilerMarker CreateMarker(string name) => ComputeKernel.CreateMarker(name);

        /// <summary>Creates a buffer.</summary>
        /// <param name="name">Name shown by frame debuggers and error messages.</param>
        /// <param name="count">Number of elements; zero gives one element.</param>
        /// <param name="stride">Bytes of an element.</param>
        /// <param name="target">What it is used for.</param>
        /// <returns>The buffer; the caller disposes it.</returns>
        /// <exception cref="FluidDeviceException">The device has too little memory for it.</exception>
        public static GraphicsBuffer CreateBuffer(string name, long count, int stride,
            GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured) => GpuBuffers.Create(name, count, stride, target);

        /// <summary>Bytes of buffers together.</summary>
        /// <param name="buffers">The buffers; null: none.</param>
        /// <returns>Bytes.</returns>
        public static long SizeOf(params GraphicsBuffer[] buffers) => GpuBuffers.Size(buffers);

        /// <summary>Bytes that a solver takes, its list of neighbours included.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="particles">Number of particles.</param>
        /// <param name="hasMesh">Whether a mesh stands in the liquid; its triangles are not counted.</param>
        /// <returns>Bytes.</returns>
        /// <exception cref="FluidDeviceException">A buffer is larger than the device allows.</exception>
        public static long PlannedBytes(in FluidSolverSettings settings, int particles, bool hasMesh)
        {
            FluidMethod method = FluidMethods.Get(settings.Method);
            return method.PlannedBytes(method.Prepare(settings), particles, hasMesh);
        }

        /// <summary>Disposes a buffer and forgets it.</summary>
        /// <param name="buffer">The buffer, or null.</param>
        public static void Dispose(ref GraphicsBuffer buffer) => GpuBuffers.Dispose(ref buffer);
    }
}
