using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of the level of detail: what is wrong with it, and in play mode which level acts and why.</summary>
    [CustomEditor(typeof(FluidLevelOfDetail)), CanEditMultipleObjects]
    public sealed class FluidLevelOfDetailEditor : PartEditor
    {
        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            base.OnInspectorGUI();
            foreach (Object edited in targets)
            {
                var detail = (FluidLevelOfDetail)edited;
                if (detail.Problem is (string text, string cure)) EditorGUILayout.HelpBox($"{text}. {cure}", MessageType.Warning);
                else if (Application.isPlaying) EditorGUILayout.HelpBox(detail.Describe(), MessageType.None);
            }
        }

        [DrawGizmo(GizmoType.Selected)]
        private static void DrawDistances(FluidLevelOfDetail detail, GizmoType type)
        {
            if (detail.Problem != null) return;
            Gizmos.matrix = Matrix4x4.TRS(detail.transform.position, detail.transform.rotation, Vector3.one);
            Color color = FluidGizmos.DomainColor;
            for (int i = 0; i < detail.Levels.Count; i++)
            {
                color.a = 1f / (i + 2);
                Gizmos.color = color;
                Gizmos.DrawWireCube(Vector3.zero, detail.BoxSize + 2f * detail.Reach * detail.Levels[i].Distance * Vector3.one);
            }
        }
    }
}
