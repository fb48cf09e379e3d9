using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the graphics device can do for the fluid, with a reason for each thing it cannot.</summary>
    public readonly struct FluidSupport
    {
        private const string OtherDevice = "Use another graphics device or API.";

        private readonly DeviceCapabilities device;

        private FluidSupport(in DeviceCapabilities device)
        {
            this.device = device;
            Messages = null;
            Messages = AllMessages();
        }

        /// <summary>One sentence for each missing capability. It is an error where no method runs.</summary>
        public IReadOnlyList<FluidMessage> Messages { get; }

        /// <summary>Whether a liquid can be simulated, by one method at least.</summary>
        public bool Simulation => Other(null) != null;

        /// <summary>Whether a liquid can be drawn as a surface, by a Fluid Surface Renderer or a Fluid Surface Mesh.</summary>
        public bool Surface => Runs(ShaderGroup.Surface) && Runs(ShaderGroup.Drawing);

        /// <summary>
        /// Whether the force of a liquid on its walls can be summed, by Fluid Probes and <see cref="SphFluid.WallForces"/>.
        /// </summary>
        public bool WallForces => Runs(ShaderGroup.WallForces);

        /// <summary>Whether a program on the CPU is the graphics device (llvmpipe, SwiftShader, WARP): liquids are small there.</summary>
        public static bool IsSoftwareDevice => DeviceCapabilities.IsSoftware;

        /// <summary>Whether counters reach the CPU without stalling it.</summary>
        public bool AsyncReadback => device.AsyncReadback;

        /// <summary>Asks the present device.</summary>
        /// <returns>The report.</returns>
        public static FluidSupport Query() => From(DeviceCapabilities.Query());

        /// <summary>Whether the device runs the kernels of a method.</summary>
        /// <param name="method">The method.</param>
        /// <returns>True when it does.</returns>
        public bool Supports(FluidMethodKind method) => Runs(FluidMethods.Get(method).Shaders);

        internal static FluidSupport From(in DeviceCapabilities device) => new FluidSupport(device);

        /// <summary>What keeps a method from running here, as errors.</summary>
        internal IReadOnlyList<FluidMessage> ErrorsOf(FluidMethodKind method)
        {
            var messages = new List<FluidMessage>();
            if (!device.ComputeShaders)
                Add(messages, FluidSeverity.Error, NoComputeShaders, ComputeCure);
            else
                AddShortfalls(messages, FluidSeverity.Error, FluidMethods.Get(method).Shaders, CureFor(FluidMethods.Get(method).Shaders));
            return messages;
        }

        private string NoComputeShaders => $"{device.Name} has no compute shaders, which the liquid is computed with.";

        private static string ComputeCure => "Use Direct3D 11 or 12, Vulkan or Metal.";

        /// <summary>Whether the device runs the shaders of a group.</summary>
        internal bool Runs(ShaderGroup needs)
        {
            if (!device.ComputeShaders) return false;
            foreach (string _ in needs.Shortfalls(device)) return false;
            return true;
        }

        private string CureFor(ShaderGroup needs) =>
            Other(needs) is FluidMethod other ? $"Set the simulation's Method to {other.Kind}, which runs here." : OtherDevice;

        // A method that runs here and has other shaders.
        private FluidMethod Other(ShaderGroup needs)
        {
            foreach (FluidMethod method in FluidMethods.All)
            {
                if (method.Shaders != needs && Runs(method.Shaders)) return method;
            }

            return null;
        }

        private List<FluidMessage> AllMessages()
        {
            var messages = new List<FluidMessage>();
            if (!device.ComputeShaders)
                Add(messages, FluidSeverity.Error, NoComputeShaders, ComputeCure);
            else
            {
                FluidSeverity severity = Simulation ? FluidSeverity.Info : FluidSeverity.Error;
                foreach (ShaderGroup needs in FluidMethods.ShaderGroups) AddShortfalls(messages, severity, needs, CureFor(needs));
                AddShortfalls(messages, FluidSeverity.Info, ShaderGroup.Surface, "Draw the liquid with a Fluid Particle Renderer.");
                AddShortfalls(messages, FluidSeverity.Info, ShaderGroup.Drawing, OtherDevice);
                foreach (ShaderGroup surface in FluidMethods.SurfaceGroups)
                {
                    AddShortfalls(messages, FluidSeverity.Info, surface, "Draw the liquid with a Fluid Surface Renderer.");
                }
                AddShortfalls(messages, FluidSeverity.Info, ShaderGroup.Diagnostics, "Leave out the Fluid Diagnostics.");
                AddShortfalls(messages, FluidSeverity.Info, ShaderGroup.WallForces,
                    "Set Kind of Fluid Probes to Liquid Pressure, which is noisy.");
                AddShortfalls(messages, FluidSeverity.Info, ShaderGroup.Whitewater, "Leave out the Fluid Whitewater.");
            }
            if (!device.AsyncReadback)
            {
                Add(messages, FluidSeverity.Info,
                    $"{device.Name} has no asynchronous readback, so the simulation's event counters are not shown.", "");
            }
            return messages;
        }

        private void AddShortfalls(List<FluidMessage> messages, FluidSeverity severity, ShaderGroup needs, string cure)
        {
            foreach (string shortfall in needs.Shortfalls(device)) Add(messages, severity, shortfall, cure);
        }

        private static void Add(List<FluidMessage> messages, FluidSeverity severity, string text, string cure) =>
            messages.Add(new FluidMessage(severity, FluidIssue.DeviceUnsupported, null, text, cure));
    }
}
