using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Editor
{
    /// <summary>Inspector of a simulation: settings, messages with fixes, live status, and a handle for the domain box.</summary>
    [CustomEditor(typeof(FluidSimulation)), CanEditMultipleObjects]
    public sealed class FluidSimulationEditor : UnityEditor.Editor
    {
        /// <summary>Fields that are always shown, in their order; the others are under Advanced.</summary>
        internal static readonly string[] Rows =
        {
            "liquid", "domain", "domainSize", "particleSpacing", "method", "colliderLayers", "paused", "timeScale",
        };

        [OutlivesPlay("what the user has unfolded")] internal static bool showsAdvanced, showsFigures;

        private readonly BoxBoundsHandle handle = new BoxBoundsHandle();
        private ValidationGUI validation;
        private RestartHold hold;
        private FluidSimulation timed; // whose steps are timed while the inspector shows it

        private FluidSimulation Simulation => (FluidSimulation)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && AnyRuns;

        private bool AnyRuns => Array.Exists(targets, t => ((FluidSimulation)t).IsRunning);

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            foreach (string field in Rows) DrawRow(field);
            showsAdvanced = EditorGUILayout.Foldout(showsAdvanced, "Advanced", true);
            if (showsAdvanced) FluidInspector.Draw(serializedObject, Rows.Concat(Hidden(serializedObject)).ToArray());
            if (serializedObject.ApplyModifiedProperties())
            {
                hold.Begin();
                validation.Refresh();
            }

            if (serializedObject.isEditingMultipleObjects)
                EditorGUILayout.HelpBox("Select one simulation to see its messages and figures.", MessageType.None);
            else
                DrawFindings();
            if (Application.isPlaying && !SceneObjects.IsPrefabAsset(Simulation)) DrawButtons();
        }

        private void DrawRow(string field)
        {
            if (field == "method") MethodField.Draw(serializedObject.FindProperty(field));
            else if (field == "particleSpacing") DrawSpacing(field);
            else FluidInspector.DrawField(serializedObject, field == "domainSize" ? SizeOf(serializedObject) : field);
        }

        // With the number of particles that it means.
        private void DrawSpacing(string field)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                FluidInspector.DrawField(serializedObject, field);
                if (!serializedObject.isEditingMultipleObjects) GUILayout.Label(CountText, EditorStyles.miniLabel, GUILayout.Width(110f));
            }
        }

        private string CountText => Simulation.IsRunning ? $"{Simulation.ParticleCount:N0} particles"
            : validation.Preview != null ? $"{validation.Preview.Particles:N0} particles" : "";

        private void DrawFindings()
        {
            showsFigures = EditorGUILayout.Foldout(showsFigures, "Figures", true);
            if (showsFigures && validation.Constants is FluidSolverSettings constants)
            {
                DrawTimeStep(constants);
                DrawDomain();
            }
            if (showsFigures && Application.isPlaying) DrawStatus();
            EditorGUILayout.Space();
            validation.Draw();
        }

        private void OnEnable()
        {
            validation = new ValidationGUI(Simulation);
            hold = new RestartHold(targets);
            Undo.undoRedoPerformed += validation.Refresh;
            EditorApplication.hierarchyChanged += validation.Refresh;
            if (!Application.isPlaying || SceneObjects.IsPrefabAsset(Simulation)) return;
            timed = Simulation;
            timed.BeginTiming();
        }

        private void OnDisable()
        {
            Undo.undoRedoPerformed -= validation.Refresh;
            EditorApplication.hierarchyChanged -= validation.Refresh;
            validation.Dispose();
            hold.End();
            if (timed != null) EndTiming();
            timed = null;
        }

        // What the inspector has measured is what it knows of such a liquid before the next play.
        private void EndTiming()
        {
            if (timed.IsRunning && timed.Timer?.FrameCount >= StepTimer.Window)
            {
                StepCostWatch.Record(timed.Timer, timed.Solver, timed.Obstacles.Count > 0);
            }
            timed.EndTiming();
        }

        private void OnSceneGUI()
        {
            FluidSimulation simulation = Simulation;
            using (new Handles.DrawingScope(FluidGizmos.DomainColor, simulation.LocalToWorld))
            {
                handle.center = Vector3.zero;
                handle.size = simulation.DomainSize;
                EditorGUI.BeginChangeCheck();
                handle.DrawHandle();
                if (!EditorGUI.EndChangeCheck()) return;
                Undo.RecordObjects(new Object[] { simulation, simulation.transform }, "Change Fluid Domain");
                simulation.transform.position = simulation.LocalToWorld.MultiplyPoint3x4(handle.center);
                simulation.DomainSize = handle.size;
                hold.Begin();
                validation.Refresh();
            }
        }

        /// <summary>Fields that none of the edited simulations reads, and the script's own.</summary>
        internal static string[] Hidden(SerializedObject edited)
        {
            var hidden = new List<string> { "m_Script" };
            if (!edited.FindProperty("domain").hasMultipleDifferentValues) hidden.Add("farthestDistance"); // or in the place of the size
            SerializedProperty mode = edited.FindProperty("timeStepMode");
            bool isFixed = mode.enumValueIndex == (int)FluidTimeStepMode.Fixed;
            if (!isFixed && !mode.hasMultipleDifferentValues) hidden.Add("fixedTimeStep");
            SerializedProperty sceneGravity = edited.FindProperty("useSceneGravity");
            if (sceneGravity.boolValue && !sceneGravity.hasMultipleDifferentValues) hidden.Add("gravity");
            SerializedProperty policy = edited.FindProperty("capacityPolicy");
            if (policy.enumValueIndex == (int)FluidCapacityPolicy.Grow && !policy.hasMultipleDifferentValues) hidden.Add("capacity");
            SerializedProperty relaxation = edited.FindProperty("startRelaxation");
            bool isSet = relaxation.enumValueIndex != (int)FluidStartRelaxation.None || relaxation.hasMultipleDifferentValues;
            if (!isSet && !AnyRelaxes(edited)) hidden.Add("startRelaxation");
            if (!isSet) hidden.Add("savedStart");
            if (!Array.Exists(edited.targetObjects, IsChosen)) hidden.AddRange(new[] { "frameBudget", "budgetFrameRate" });
            return hidden.ToArray();
        }

        /// <summary>The field that says how large the domain is.</summary>
        internal static string SizeOf(SerializedObject edited) => edited.FindProperty("domain") is SerializedProperty domain &&
            !domain.hasMultipleDifferentValues && domain.enumValueIndex == (int)FluidDomain.Open ? "farthestDistance" : "domainSize";

        private static bool IsChosen(Object simulation) => FluidMethods.IsChosen(((FluidSimulation)simulation).Method);

        private static bool AnyRelaxes(SerializedObject edited) =>
            Array.Exists(edited.targetObjects, t => FluidMethods.Has(((FluidSimulation)t).ActiveMethod, FluidMethodFeatures.RelaxedStart));

        private void DrawTimeStep(in FluidSolverSettings constants)
        {
            TimeStepText text = Simulation.IsRunning ? TimeStepText.Now(Simulation) : TimeStepText.Before(Simulation, constants);
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Constants by Rule", EditorStyles.boldLabel);
            DrawLines(text.Lines);
            EditorGUILayout.HelpBox(text.Advice, MessageType.None);
        }

        private void DrawDomain()
        {
            if (!Simulation.IsRunning && validation.Preview == null) return;
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Domain in Use", EditorStyles.boldLabel);
            DrawFill();
            DrawLines((Simulation.IsRunning ? DomainText.Now(Simulation) : DomainText.Before(Simulation, validation.Preview)).Lines);
        }

        private void DrawFill()
        {
            if (Application.isPlaying) return;
            if (FillGizmos.Text(validation.Memory) is string text) EditorGUILayout.HelpBox(text, MessageType.None);
            bool isSaved = Simulation.StartRelaxation == FluidStartRelaxation.Saved;
            bool relaxes = Simulation.StartRelaxation != FluidStartRelaxation.None &&
                FluidMethods.Has(Simulation.ActiveMethod, FluidMethodFeatures.RelaxedStart);
            if (!relaxes || validation.Preview == null) return;
            if (!isSaved && !validation.Memory.IsRelaxed && GUILayout.Button("Preview Relaxed Start")) validation.Relax();
            if (GUILayout.Button("Save Relaxed Start")) RelaxedStartAsset.TrySave(Simulation);
        }

        private static void DrawLines(IReadOnlyList<(string Label, string Value)> lines)
        {
            foreach ((string label, string value) in lines) EditorGUILayout.LabelField(label, value);
        }

        private void DrawStatus()
        {
            FluidSimulation simulation = Simulation;
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Status", EditorStyles.boldLabel);
            EditorGUILayout.LabelField("State", !simulation.IsRunning ? "stopped" : simulation.Paused ? "paused" : simulation.IsAsleep
                ? "asleep" : simulation.AsleepShare > 0f ? $"running, {100f * simulation.AsleepShare:0} % asleep" : "running");
            if (simulation.IsRunning)
            {
                if (simulation.MethodChoice is FluidMethodChoice choice)
                {
                    EditorGUILayout.LabelField("Method in use", MethodChoiceText.Short(choice));
                }
                FluidCounters counters = simulation.Solver.Counters;
                EditorGUILayout.LabelField("Simulated time", $"{simulation.SimulatedTime:0.00} s in {simulation.StepCount:N0} steps");
                EditorGUILayout.LabelField("Real-time factor",
                    $"{simulation.RealTimeFactor:0.00} ({simulation.CapHits} frames at the substep cap)");
                EditorGUILayout.LabelField("Fastest particle", $"{counters.MaxSpeed:0.00} m/s");
                EditorGUILayout.LabelField("Largest compression", $"{100f * counters.MaxCompression:0.0} %");
            }
        }

        // All selected simulations at once.
        private void DrawButtons()
        {
            bool all = Array.TrueForAll(targets, t => ((FluidSimulation)t).IsRunning);
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button(all ? "Restart" : "Start")) Each(simulation => simulation.ResetSimulation());
                using (new EditorGUI.DisabledScope(!AnyRuns))
                    if (GUILayout.Button("Stop")) Each(simulation => simulation.StopSimulation());
                if (Array.Exists(targets, IsChosen) && GUILayout.Button("Choose Again")) Each(ChooseAgain);
            }
        }

        private static void ChooseAgain(FluidSimulation simulation)
        {
            if (IsChosen(simulation)) simulation.ChooseMethodAgain();
        }

        private void Each(Action<FluidSimulation> act)
        {
            foreach (Object edited in targets) act((FluidSimulation)edited);
        }
    }
}
