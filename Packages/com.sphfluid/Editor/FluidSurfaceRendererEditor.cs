using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>
    /// Inspector of the surface: the settings of its look, how the render pipeline serves it, and in play mode what it is made of.
    /// </summary>
    [CustomEditor(typeof(FluidSurfaceRenderer))]
    [CanEditMultipleObjects]
    public sealed class FluidSurfaceRendererEditor : UnityEditor.Editor
    {
        private FluidSurfaceRenderer Renderer => (FluidSurfaceRenderer)target;

        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && !serializedObject.isEditingMultipleObjects &&
            Renderer.isActiveAndEnabled;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            DrawPropertiesExcluding(serializedObject, Hidden(serializedObject));
            serializedObject.ApplyModifiedProperties();
            if (Array.Exists(targets, t => ((FluidSurfaceRenderer)t).Look == FluidSurfaceLook.Water))
            {
                WaterRoute route = WaterRoute.Active;
                EditorGUILayout.HelpBox(route.Text, route.IsComplete ? MessageType.Info : MessageType.Warning);
            }
            if (Application.isPlaying && !serializedObject.isEditingMultipleObjects)
            {
                SurfaceStatusGUI.Draw(Renderer.Status, Renderer.GpuBytes);
            }
        }

        /// <summary>Fields that none of the edited objects reads, and the script's own.</summary>
        internal static string[] Hidden(SerializedObject edited)
        {
            SerializedProperty look = edited.FindProperty("look");
            return look.hasMultipleDifferentValues ? new[] { "m_Script" } : Hidden((FluidSurfaceLook)look.enumValueIndex);
        }

        /// <summary>Fields that a look does not read, and the script's own.</summary>
        /// <param name="look">The look.</param>
        /// <returns>Names of serialised fields.</returns>
        public static string[] Hidden(FluidSurfaceLook look)
        {
            var hidden = new List<string> { "m_Script" };
            hidden.AddRange(look == FluidSurfaceLook.Water ? new[] { "color", "smoothness" } : new[] { "water" });
            return hidden.ToArray();
        }
    }
}
