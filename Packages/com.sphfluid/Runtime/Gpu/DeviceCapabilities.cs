using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The figures of a graphics device that the fluid asks for.</summary>
    internal struct DeviceCapabilities
    {
        public string Name;
        public bool ComputeShaders;
        public bool GeometryShaders;
        public bool AsyncReadback;
        public int GroupThreads;
        public int ComputeBuffers;
        public int VertexBuffers;

        // Device names of Mesa's, Google's and Microsoft's rasterisers.
        private static readonly string[] SoftwareDevices = { "llvmpipe", "SwiftShader", "Microsoft Basic Render" };

        /// <summary>Whether a program on the CPU is the graphics device.</summary>
        public static bool IsSoftware =>
            Array.Exists(SoftwareDevices, name => SystemInfo.graphicsDeviceName.IndexOf(name, StringComparison.OrdinalIgnoreCase) >= 0);

        public static DeviceCapabilities Query() => new DeviceCapabilities
        {
            Name = $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType})",
            ComputeShaders = SystemInfo.supportsComputeShaders,
            GeometryShaders = SystemInfo.supportsGeometryShaders,
            AsyncReadback = SystemInfo.supportsAsyncGPUReadback,
            GroupThreads = SystemInfo.maxComputeWorkGroupSize,
            ComputeBuffers = SystemInfo.maxComputeBufferInputsCompute,
            VertexBuffers = SystemInfo.maxComputeBufferInputsVertex,
        };
    }
}
