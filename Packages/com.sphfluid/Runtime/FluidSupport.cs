using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the graphics device can do for the fluid, with a reason for each thing it cannot.</summary>
    public readonly struct FluidSupport
    {
        /// <summary>Threads of the largest kernel group, that of BitonicSort.</summary>
        internal const int GroupThreads = 1024;

        /// <summary>Structured buffers that the largest kernel binds.</summary>
        internal const int ComputeBuffers = 8;

        FluidSupport(IReadOnlyList<FluidMessage> messages, bool simulation, bool geometrySurface, bool asyncReadback)
        {
            Messages = messages;
            Simulation = simulation;
            GeometrySurface = geometrySurface;
            AsyncReadback = asyncReadback;
        }

        /// <summary>One sentence for each missing capability.</summary>
        public IReadOnlyList<FluidMessage> Messages { get; }

        /// <summary>Whether the liquid can be simulated.</summary>
        public bool Simulation { get; }

        /// <summary>Whether the thesis's surface can be drawn; the sparse one needs no geometry shader.</summary>
        public bool GeometrySurface { get; }

        /// <summary>Whether counters reach the CPU without stalling it.</summary>
        public bool AsyncReadback { get; }

        /// <summary>Asks the present device.</summary>
        /// <returns>The report.</returns>
        public static FluidSupport Query() => From(DeviceCapabilities.Query());

        internal static FluidSupport From(in DeviceCapabilities device)
        {
            var messages = new List<FluidMessage>();
            if (!device.ComputeShaders)
                Add(messages, FluidSeverity.Error, $"{device.Name} has no compute shaders, which the liquid is computed with.",
                    "Use Direct3D 11 or 12, Vulkan or Metal.");
            else
            {
                if (device.GroupThreads < GroupThreads)
                    Add(messages, FluidSeverity.Error, $"{device.Name} runs compute groups of {device.GroupThreads} threads; the sort needs {GroupThreads}.",
                        "Use another graphics device.");
                if (device.ComputeBuffers < ComputeBuffers)
                    Add(messages, FluidSeverity.Error, $"{device.Name} binds {device.ComputeBuffers} buffers to a compute shader; the liquid needs {ComputeBuffers}.",
                        "Use another graphics device or API.");
            }
            bool simulation = messages.Count == 0;
            if (!device.GeometryShaders)
                Add(messages, FluidSeverity.Info, $"{device.Name} has no geometry shaders, which the thesis's surface is made with.",
                    "Draw the liquid with a Fluid Surface Renderer.");
            if (!device.AsyncReadback)
                Add(messages, FluidSeverity.Info, $"{device.Name} has no asynchronous readback, so the simulation's event counters are not shown.", "");
            return new FluidSupport(messages, simulation, device.GeometryShaders, device.AsyncReadback);
        }

        static void Add(List<FluidMessage> messages, FluidSeverity severity, string text, string cure) =>
            messages.Add(new FluidMessage(severity, FluidIssue.DeviceUnsupported, null, text, cure));
    }

    /// <summary>The figures of a graphics device that the fluid asks for.</summary>
    internal struct DeviceCapabilities
    {
        public string Name;
        public bool ComputeShaders;
        public bool GeometryShaders;
        public bool AsyncReadback;
        public int GroupThreads;
        public int ComputeBuffers;

        public static DeviceCapabilities Query() => new DeviceCapabilities
        {
            Name = $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType})",
            ComputeShaders = SystemInfo.supportsComputeShaders,
            GeometryShaders = SystemInfo.supportsGeometryShaders,
            AsyncReadback = SystemInfo.supportsAsyncGPUReadback,
            GroupThreads = SystemInfo.maxComputeWorkGroupSize,
            ComputeBuffers = SystemInfo.maxComputeBufferInputsCompute,
        };
    }
}
