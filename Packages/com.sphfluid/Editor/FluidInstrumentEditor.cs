using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of probes, gauges and fluxes: what they read, and what is wrong.</summary>
    [CustomEditor(typeof(FluidInstrument), true)]
    [CanEditMultipleObjects]
    public sealed class FluidInstrumentEditor : UnityEditor.Editor
    {
        private FluidInstrument Shown => (FluidInstrument)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects &&
            Shown.isActiveAndEnabled;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            bool isProbe = target is FluidProbe;
            SerializedProperty kind = isProbe ? serializedObject.FindProperty("kind") : null;
            bool hasPatch = !isProbe || kind.hasMultipleDifferentValues || kind.enumValueIndex == (int)FluidProbeKind.WallPressure;
            FluidInspector.Draw(serializedObject, hasPatch ? new string[0] : new[] { "patchSize" });
            serializedObject.ApplyModifiedProperties();
            if (serializedObject.isEditingMultipleObjects) return;
            if (Shown.Problem is FluidMessage problem) EditorGUILayout.HelpBox($"{problem.Text} {problem.Cure}", MessageType.Warning);
            if (!Application.isPlaying) return;
            foreach (FluidReading reading in Shown.Readings)
            {
                EditorGUILayout.LabelField(ObjectNames.NicifyVariableName(InstrumentText.NameOf(reading)),
                    InstrumentText.Describe(reading));
            }
        }
    }
}
