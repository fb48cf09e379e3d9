using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of shader sets: names what is missing and fills it from the package.</summary>
    [CustomEditor(typeof(FluidShaderSet)), CanEditMultipleObjects]
    public sealed class FluidShaderSetEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidInspector.Draw(serializedObject);
            serializedObject.ApplyModifiedProperties();

            foreach (Object edited in targets) DrawMissing((FluidShaderSet)edited);
        }

        private static void DrawMissing(FluidShaderSet set)
        {
            IReadOnlyList<string> missing = PackageShaders.Missing(set);
            if (missing.Count == 0) return;
            var message = new FluidMessage(
                FluidSeverity.Error, FluidIssue.ShadersMissing, set, $"'{set.name}' has no {string.Join(", ", missing)}.", "");
            EditorGUILayout.HelpBox(message.Text, MessageType.Error);
            if (FluidFix.For(message, null) is FluidFix fix && GUILayout.Button(fix.Label)) fix.Apply();
        }
    }
}
