using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Probes and gauges of a liquid as an export has them; others are reported.</summary>
    internal static class ExportInstruments
    {
        /// <summary>Finds them where they are now.</summary>
        /// <param name="simulation">Whose they are.</param>
        /// <param name="found">Receives them.</param>
        /// <param name="report">Receives those that cannot be exported.</param>
        public static void Find(FluidSimulation simulation, List<ExportInstrument> found, Action<FluidMessage> report)
        {
            FluidSimulation[] simulations = SceneObjects.Find<FluidSimulation>(simulation);
            DomainPose toSimulation = DomainSpace.FromWorld(simulation.transform.position, simulation.transform.rotation);
            FluidInstrument[] instruments = SceneObjects.Find<FluidInstrument>(simulation);
            Array.Sort(instruments, HierarchyOrder.Compare);
            foreach (FluidInstrument instrument in instruments)
                if (instrument.enabled && FluidScene.Owner(instrument, instrument.Simulation, simulations) == simulation)
                {
                    Add(instrument, toSimulation, found, report);
                }
            FluidSensor[] sensors = SceneObjects.Find<FluidSensor>(simulation);
            Array.Sort(sensors, HierarchyOrder.Compare);
            foreach (FluidSensor sensor in sensors)
                if (sensor.enabled && FluidScene.Owner(sensor, sensor.Simulation, simulations) == simulation)
                {
                    Say(report, sensor, "The sensor is not exported: what it switches is in the scene.",
                        "Add a Fluid Probe or a Fluid Gauge where the reading is wanted.");
                }
        }

        private static void Add(FluidInstrument instrument, in Matrix4x4 toSimulation, List<ExportInstrument> found,
            Action<FluidMessage> report)
        {
            var exported =
                new ExportInstrument { Name = instrument.name, Place = toSimulation.MultiplyPoint3x4(instrument.transform.position) };
            switch (instrument)
            {
                case FluidGauge gauge:
                    exported.Property = "height";
                    exported.Up = toSimulation.MultiplyVector(gauge.transform.up).normalized;
                    exported.Length = gauge.Length;
                    found.Add(exported);
                    break;
                case FluidProbe probe:
                    foreach (string property in PropertiesOf(probe.Kind))
                    {
                        exported.Property = property;
                        found.Add(exported);
                    }
                    break;
                default:
                    Say(report, instrument, "The instrument is not exported: only probes and gauges are.", "");
                    break;
            }
        }

        private static string[] PropertiesOf(FluidProbeKind kind) =>
            kind == FluidProbeKind.Velocity ? new[] { "u", "v", "w" } : kind == FluidProbeKind.Density ? new[] { "rho" } : new[] { "p" };

        private static void Say(Action<FluidMessage> report, Component about, string text, string cure) =>
            report(new FluidMessage(FluidSeverity.Warning, FluidIssue.NotExported, about, text, cure));
    }
}
