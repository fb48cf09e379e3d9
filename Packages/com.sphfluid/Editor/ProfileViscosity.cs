using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// The lines on viscosity and surface tension below a profile, found again now and then: before the start a liquid has to be filled to
    /// know its constants.
    /// </summary>
    internal sealed class ProfileViscosity
    {
        private const double LeastInterval = 0.5;
        private const double LoadShare = 20.0;
        private const int MostLines = 4;

        private readonly FluidProfile profile;
        private string text = "";
        private double next;

        public ProfileViscosity(FluidProfile profile) => this.profile = profile;

        /// <summary>Draws the lines.</summary>
        public void Draw()
        {
            double now = EditorApplication.timeSinceStartup;
            if (Event.current.type == EventType.Layout && now >= next)
            {
                next = now + LeastInterval;
                text = Find(profile);
                next = now + Math.Max(LeastInterval, LoadShare * (EditorApplication.timeSinceStartup - now));
            }
            EditorGUILayout.HelpBox(text, MessageType.None);
        }

        /// <summary>A line for each simulation of the loaded scenes that uses the profile.</summary>
        internal static string Find(FluidProfile profile)
        {
            FluidSimulation[] users = SceneObjects.All<FluidSimulation>(FindObjectsInactive.Include)
                .Where(s => s.Profile == profile).OrderBy(s => s.name, StringComparer.Ordinal).ToArray();
            if (users.Length == 0) return ViscosityText.Unused(profile);
            List<string> lines = users.Take(MostLines).Select(Line).ToList();
            if (users.Length > MostLines) lines.Add($"and {users.Length - MostLines} more simulations");
            return string.Join("\n", lines);
        }

        private static string Line(FluidSimulation simulation)
        {
            if (simulation.IsRunning) return Line(simulation, simulation.Solver.Settings);
            FluidSimulationChecks.Preview(simulation, out FluidSolverSettings? constants);
            return constants.HasValue ? Line(simulation, constants.Value) : $"'{simulation.name}' cannot start; its inspector says why.";
        }

        private static string Line(FluidSimulation simulation, in FluidSolverSettings constants)
        {
            string tension = SurfaceTensionText.Describe(simulation, constants);
            return ViscosityText.Describe(simulation, constants) + (tension == "" ? "" : "\n" + tension);
        }
    }
}
