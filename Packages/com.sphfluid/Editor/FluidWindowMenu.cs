using System.Text;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Window > SPH Fluid: reports about the device and the open scenes, written to the console.</summary>
    public static class FluidWindowMenu
    {
        private const string Root = "Window/SPH Fluid/";

        /// <summary>Writes what the graphics device can do for the fluid.</summary>
        [MenuItem(Root + "Report Device Support", false, 3000)]
        public static void ReportSupport()
        {
            FluidSupport support = FluidSupport.Query();
            var text = new StringBuilder();
            text.Append($"{FluidMessage.Prefix} {SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}): ");
            foreach (ShaderGroup method in FluidMethods.ShaderGroups) text.Append($"{method.Part} {YesNo(support.Runs(method))}, ");
            foreach (ShaderGroup surface in FluidMethods.SurfaceGroups) text.Append($"{surface.Part} {YesNo(support.Runs(surface))}, ");
            text.AppendLine($"surface {YesNo(support.Surface)}, asynchronous readback {YesNo(support.AsyncReadback)}.");
            foreach (FluidMessage message in support.Messages) text.AppendLine($"{message.Text} {message.Cure}");
            Debug.Log(text.ToString());
        }

        /// <summary>Checks every simulation of the open scenes and writes what is wrong.</summary>
        [MenuItem(Root + "Validate Open Scenes", false, 3001)]
        public static void ValidateScenes()
        {
            int simulations = 0, messages = 0;
            foreach (FluidSimulation simulation in SceneObjects.All<FluidSimulation>())
            {
                simulations++;
                foreach (FluidMessage message in simulation.Validate())
                {
                    message.Log();
                    messages++;
                }
            }
            Debug.Log($"{FluidMessage.Prefix} {simulations} simulations checked, {messages} messages.");
        }

        private static string YesNo(bool value) => value ? "yes" : "no";
    }
}
