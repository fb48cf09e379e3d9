using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of the diagnostics: settings, and in play mode the findings and the last measurement.</summary>
    [CustomEditor(typeof(FluidDiagnostics)), CanEditMultipleObjects]
    public sealed class FluidDiagnosticsEditor : UnityEditor.Editor
    {
        private FluidDiagnostics Diagnostics => (FluidDiagnostics)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects &&
            Diagnostics.isActiveAndEnabled;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            DrawPropertiesExcluding(serializedObject, "m_Script");
            serializedObject.ApplyModifiedProperties();
            if (!Application.isPlaying) return;
            if (serializedObject.isEditingMultipleObjects)
            {
                EditorGUILayout.HelpBox("Select one object to see its findings.", MessageType.None);
                return;
            }
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Findings", EditorStyles.boldLabel);
            if (Diagnostics.Findings.Count == 0)
            {
                EditorGUILayout.LabelField(Diagnostics.MeasurementCount > 0 ? "none" : "nothing measured yet");
            }
            foreach (FluidFinding finding in Diagnostics.Findings)
            {
                EditorGUILayout.HelpBox($"{ObjectNames.NicifyVariableName(finding.Failure.ToString())}: {finding.Text} {finding.Cure}",
                    MessageType.Warning);
            }
            if (Diagnostics.MeasurementCount > 0) DrawStatistics(Diagnostics.Statistics);
        }

        private static void DrawStatistics(in FluidStatistics statistics)
        {
            EditorGUILayout.Space();
            EditorGUILayout.LabelField("Statistics", EditorStyles.boldLabel);
            EditorGUILayout.LabelField("At", $"{statistics.Time:0.000} s");
            EditorGUILayout.LabelField("Energy",
                $"{statistics.Energy:G4} J (kinetic {statistics.KineticEnergy:G3}, elastic {statistics.ElasticEnergy:G3})");
            EditorGUILayout.LabelField("Fastest", $"{statistics.MaxSpeed:G3} m/s");
            EditorGUILayout.LabelField("Density / rest density", $"{statistics.MinDensityRatio:0.00} to {statistics.MaxDensityRatio:0.00}");
            EditorGUILayout.LabelField("Mean compression", $"{100.0 * statistics.MeanCompression:0.0} %");
            EditorGUILayout.LabelField("Most neighbours", statistics.MaxNeighbours.ToString());
            EditorGUILayout.LabelField("Clumped, escaped", $"{statistics.Clumped}, {statistics.Escaped}");
            EditorGUILayout.LabelField("Not finite", statistics.NonFinite.ToString());
        }
    }
}
