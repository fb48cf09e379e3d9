using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Help boxes for messages, with a button where there is a cure.</summary>
    internal sealed class ValidationGUI
    {
        const double LeastInterval = 0.5;
        const double LoadShare = 20.0;

        readonly FluidSimulation simulation;
        IReadOnlyList<FluidMessage> messages = Array.Empty<FluidMessage>();
        FluidSolverSettings? constants;
        double nextCheck;

        public ValidationGUI(FluidSimulation simulation) => this.simulation = simulation;

        /// <summary>Constants that the simulation runs with, or would start with; null when it cannot.</summary>
        public FluidSolverSettings? Constants => simulation.IsRunning ? simulation.Solver.Settings : constants;

        /// <summary>Checks again at the next draw.</summary>
        public void Refresh() => nextCheck = 0.0;

        /// <summary>Draws the messages: of the run while playing, else of a check that is repeated now and then.</summary>
        public void Draw()
        {
            if (Event.current.type == EventType.Layout) Update();
            foreach (FluidMessage message in messages) Draw(message);
        }

        // A check fills the liquid volumes: a large scene is checked less often, so that it takes 5 % of the time at most.
        void Update()
        {
            if (Application.isPlaying && (simulation.IsRunning || simulation.Messages.Count > 0))
            {
                messages = new List<FluidMessage>(simulation.Messages);
                return;
            }
            double now = EditorApplication.timeSinceStartup;
            if (now < nextCheck) return;
            nextCheck = now + LeastInterval; // should the check throw, it does not do so at every repaint
            List<FluidMessage> found = FluidSimulationChecks.Preview(simulation, out constants);
            if (ViewRules.Check(simulation) is FluidMessage unseen) found.Add(unseen);
            messages = found;
            double took = EditorApplication.timeSinceStartup - now;
            nextCheck = now + Math.Max(LeastInterval, LoadShare * took);
        }

        void Draw(in FluidMessage message)
        {
            string text = message.Cure.Length == 0 ? message.Text : $"{message.Text} {message.Cure}";
            if (message.Context != null && message.Context != simulation) text = $"{message.Source}: {text}";
            EditorGUILayout.HelpBox(text, TypeOf(message.Severity));
            using (new EditorGUILayout.HorizontalScope())
            {
                GUILayout.FlexibleSpace();
                if (message.Context != null && message.Context != simulation && GUILayout.Button("Show", GUILayout.Width(60f)))
                    EditorGUIUtility.PingObject(message.Context);
                FluidFix? fix = FluidFix.For(message, simulation);
                if (fix.HasValue && GUILayout.Button(fix.Value.Label, GUILayout.Width(150f)))
                {
                    fix.Value.Apply();
                    Refresh();
                }
            }
        }

        static MessageType TypeOf(FluidSeverity severity)
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
