using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Window > SPH Fluid > Export to PySPH: the liquids of the open scenes as cases that run on many processors.</summary>
    public sealed class FluidExportWindow : EditorWindow
    {
        private const string Path = "Window/SPH Fluid/Export to PySPH";

        private readonly List<string> lines = new List<string>();
        private string folder = "Build/export";
        private double seconds = 2.0, frameRate = 30.0;
        private int scheme, ranks = 2;
        private FluidExportRecorder recorder;

        /// <summary>Opens the window.</summary>
        [MenuItem(Path, false, 3002)]
        public static void Open() => GetWindow<FluidExportWindow>("Export to PySPH");

        /// <summary>What was exported last and what of it was left out, line by line.</summary>
        internal IReadOnlyList<string> Lines => lines;

        /// <summary>Where the cases go; several liquids each to a folder of its name in it.</summary>
        internal string Folder { get => folder; set => folder = value; }

        private void OnGUI()
        {
            folder = EditorGUILayout.TextField("Folder", folder);
            seconds = EditorGUILayout.FloatField("Seconds", (float)seconds);
            frameRate = EditorGUILayout.FloatField("Frames a second", (float)frameRate);
            scheme = EditorGUILayout.Popup("Scheme", scheme, new[] { "WCSPH", "EDAC" });
            ranks = EditorGUILayout.IntField("Processes", ranks);
            EditorGUILayout.HelpBox(Application.isPlaying
                ? "The liquids are exported as they are now, with the motion that colliders have from now on."
                : "The liquids are exported as they start. Colliders stay where they are: export in play mode to record their motion.",
                MessageType.Info);
            if (recorder != null) EditorGUILayout.LabelField($"Recording colliders: {100f * recorder.Progress:0} %");
            else if (GUILayout.Button("Export")) Export();
            if (lines.Count > 0) EditorGUILayout.HelpBox(string.Join("\n", lines), MessageType.None);
        }

        private void OnDisable() => recorder?.Dispose();

        private void OnInspectorUpdate()
        {
            if (recorder != null) Repaint();
        }

        /// <summary>Exports what the fields ask for: at once, or in play mode when its time is recorded.</summary>
        internal void Export()
        {
            lines.Clear();
            var options =
                new FluidExportOptions { Seconds = seconds, FrameRate = frameRate, Scheme = (FluidExportScheme)scheme, Ranks = ranks };
            FluidSimulation[] simulations = SceneObjects.All<FluidSimulation>().Where(s => s.isActiveAndEnabled).ToArray();
            Array.Sort(simulations, HierarchyOrder.Compare);
            if (simulations.Length == 0)
            {
                lines.Add("No Fluid Simulation is enabled in the open scenes. Add one: GameObject > Fluid > Tank.");
            }
            try
            {
                if (Application.isPlaying && simulations.Length > 0)
                {
                    recorder = FluidExportRecorder.Begin(simulations, options, exports => Write(simulations, exports));
                    return;
                }
                FluidExport[] exports = simulations.Select(s => FluidExport.Begin(s, options)).ToArray();
                Write(simulations, exports);
                foreach (FluidExport export in exports) export.Dispose();
            }
            catch (ArgumentException exception)
            {
                lines.Add(exception.Message);
            }
        }

        private void Write(IReadOnlyList<FluidSimulation> simulations, IReadOnlyList<FluidExport> exports)
        {
            recorder = null;
            string[] folders = FluidExport.FoldersOf(simulations, folder);
            for (int i = 0; i < exports.Count; i++)
            {
                FluidExport export = exports[i];
                lines.AddRange(export.Messages.Select(m => $"{m}"));
                if (!export.HasLiquid) continue;
                try
                {
                    string path = folders[i];
                    long bytes = export.Write(path);
                    lines
                        .Add(
                            FormattableString.Invariant($"{export.ParticleCount} particles of liquid and {export.WallParticleCount} of ") +
                            FormattableString.Invariant($"walls, {bytes / 1e6:0.0} MB, in {path}."));
                }
                catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
                {
                    lines.Add(exception.Message);
                }
            }
        }
    }
}
