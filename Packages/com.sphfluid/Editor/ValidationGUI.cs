using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Editor
{
    /// <summary>Help boxes for messages about a simulation, with a button where there is a cure, and what it would start with.</summary>
    internal sealed class ValidationGUI : IDisposable
    {
        private const double LeastInterval = 0.5;
        private const double LoadShare = 20.0;
        private const double SilentSeconds = 1.0;

        private readonly FluidSimulation simulation;
        private readonly PreviewMemory memory = new PreviewMemory();
        private List<FluidMessage> messages = new List<FluidMessage>();
        private double nextCheck;
        private bool showsProgress;

        public ValidationGUI(FluidSimulation simulation)
        {
            this.simulation = simulation;
            FillGizmos.Show(simulation, memory);
        }

        /// <summary>Constants that the simulation runs with, or would start with; null when it cannot.</summary>
        public FluidSolverSettings? Constants => simulation.IsRunning ? simulation.Solver.Settings : Preview?.Constants;

        /// <summary>What the simulation would start with; null when it cannot.</summary>
        public FluidPreview Preview => memory.Preview;

        /// <summary>What is known of the start.</summary>
        public PreviewMemory Memory => memory;

        /// <summary>Checks again at the next draw.</summary>
        public void Refresh() => nextCheck = 0.0;

        /// <summary>Draws the messages: of the run while playing, else of a check that is repeated now and then.</summary>
        /// <param name="about">The object that they are about; null: all are drawn.</param>
        public void Draw(Object about = null)
        {
            if (Event.current.type == EventType.Layout) Update();
            foreach (FluidMessage message in messages)
                if (about == null || message.Context == about) Draw(message, about != null);
        }

        /// <summary>Brings the liquid to rest as its start would, with a progress bar.</summary>
        public void Relax()
        {
            var said = new List<FluidMessage>();
            try
            {
                memory.TryRelax(simulation.Spec, FluidScene.Volumes(simulation), simulation.Watch, said.Add);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                said.Add(FluidReports.Failure(simulation, exception));
            }
            foreach (FluidMessage message in said) message.Log();
            SceneView.RepaintAll();
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            FillGizmos.Forget(simulation, memory);
            memory.Dispose();
        }

        // A check of a large scene is repeated less often, so that it takes 5 % of the time at most.
        private void Update()
        {
            if (Application.isPlaying && (simulation.IsRunning || simulation.Messages.Count > 0))
            {
                messages = new List<FluidMessage>(simulation.Messages);
                LiquidRules.Check(simulation, messages);
                return;
            }
            double now = EditorApplication.timeSinceStartup;
            if (now < nextCheck) return;
            nextCheck = now + LeastInterval; // should the check throw, it does not do so at every repaint
            FillPoints before = memory.Points;
            try
            {
                if (memory.Look(simulation.Spec, FluidScene.Volumes(simulation), now, GoesOn, ref messages))
                {
                    if (ViewRules.Check(simulation) is FluidMessage unseen) messages.Add(unseen);
                    LiquidRules.Check(simulation, messages);
                }
            }
            finally
            {
                if (showsProgress) EditorUtility.ClearProgressBar();
                showsProgress = false;
            }
            if (memory.Points != before) SceneView.RepaintAll();
            double took = EditorApplication.timeSinceStartup - now;
            nextCheck = now + Math.Max(LeastInterval, LoadShare * took);
        }

        private bool GoesOn(double seconds)
        {
            if (seconds < SilentSeconds || Application.isBatchMode) return true;
            showsProgress = true;
            return !EditorUtility.DisplayCancelableProgressBar("Fluid Simulation", $"'{simulation.name}': counting its particles", 0.5f);
        }

        private void Draw(in FluidMessage message, bool aboutOne)
        {
            string text = message.Cure.Length == 0 ? message.Text : $"{message.Text} {message.Cure}";
            bool isElsewhere = !aboutOne && message.Context != null && message.Context != simulation;
            if (isElsewhere) text = $"{message.Source}: {text}";
            EditorGUILayout.HelpBox(text, TypeOf(message.Severity));
            using (new EditorGUILayout.HorizontalScope())
            {
                GUILayout.FlexibleSpace();
                if (isElsewhere && GUILayout.Button("Show", GUILayout.Width(60f))) EditorGUIUtility.PingObject(message.Context);
                FluidFix? fix = FluidFix.For(message, simulation);
                if (fix.HasValue && GUILayout.Button(fix.Value.Label, GUILayout.Width(150f)))
                {
                    fix.Value.Apply();
                    Refresh();
                }
            }
        }

        private static MessageType TypeOf(FluidSeverity severity)
        {
            switch (severity)
            {
                case FluidSeverity.Error: return MessageType.Error;
                case FluidSeverity.Warning: return MessageType.Warning;
                default: return MessageType.Info;
            }
        }
    }
}
