using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of the surface as a mesh: whether something draws it, and in play mode what it is made of.</summary>
    [CustomEditor(typeof(FluidSurfaceMesh))]
    [CanEditMultipleObjects]
    public sealed class FluidSurfaceMeshEditor : UnityEditor.Editor
    {
        private FluidSurfaceMesh Handed => (FluidSurfaceMesh)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects &&
            Handed.isActiveAndEnabled;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidInspector.Draw(serializedObject);
            serializedObject.ApplyModifiedProperties();
            if (serializedObject.isEditingMultipleObjects) return;
            string unseen = Handed.WhyUnseen();
            if (unseen != null) EditorGUILayout.HelpBox(unseen, MessageType.Warning);
            if (Application.isPlaying) SurfaceStatusGUI.Draw(Handed.Status, Handed.GpuBytes);
        }
    }
}
