using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// Inspector of profiles: the fields that the methods of the simulations with this profile read, the others folded away.
    /// </summary>
    [CustomEditor(typeof(FluidProfile)), CanEditMultipleObjects]
    public sealed class FluidProfileEditor : UnityEditor.Editor
    {
        [OutlivesPlay("what the user has unfolded")] private static bool showsOthers;
        private ProfileViscosity viscosity;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            string[] unread = Unread(MethodsOf(targets));
            FluidInspector.Draw(serializedObject, unread);
            if (unread.Length > 0) DrawUnread(unread);
            serializedObject.ApplyModifiedProperties();
            if (!serializedObject.isEditingMultipleObjects) (viscosity ??= new ProfileViscosity((FluidProfile)target)).Draw();
        }

        private void DrawUnread(IEnumerable<string> fields)
        {
            EditorGUILayout.Space();
            showsOthers = EditorGUILayout.Foldout(showsOthers, "Fields of Other Methods", true);
            if (!showsOthers) return;
            EditorGUILayout.HelpBox("No simulation of the open scenes that uses this profile computes by a method that reads these.",
                MessageType.None);
            foreach (string field in fields) FluidInspector.DrawField(serializedObject, field);
        }

        /// <summary>Methods of the loaded simulations that use one of the profiles.</summary>
        internal static FluidMethodKind[] MethodsOf(IReadOnlyCollection<Object> profiles) =>
            SceneObjects.All<FluidSimulation>(FindObjectsInactive.Include)
                .Where(s => s.Profile != null && profiles.Contains(s.Profile)).Select(s => s.ActiveMethod).Distinct().ToArray();

        /// <summary>Fields that none of the methods reads, in the order of the list of methods; none where no method is in use.</summary>
        internal static string[] Unread(IReadOnlyCollection<FluidMethodKind> inUse)
        {
            if (inUse.Count == 0) return new string[0];
            var read = FluidMethods.All.Where(m => inUse.Contains(m.Kind)).SelectMany(m => m.ProfileFields);
            return FluidMethods.All.SelectMany(m => m.ProfileFields).Distinct().Except(read).ToArray();
        }
    }
}
