using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

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
            FluidLiquid liquid = LiquidOf(targets);
            FluidInspector.Draw(serializedObject, Hidden(serializedObject, liquid));
            serializedObject.ApplyModifiedProperties();
            if (liquid != null)
            {
                EditorGUILayout.HelpBox($"Drawn as '{liquid.name}'. Switch Own Look on for a look of its own.", MessageType.Info);
            }
            if (Array.Exists(targets, t => ((FluidSurfaceRenderer)t).ActiveLook == FluidSurfaceLook.Water))
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
        /// <param name="edited">The objects.</param>
        /// <param name="liquid">What all of them are drawn as; null: as their rows say.</param>
        internal static string[] Hidden(SerializedObject edited, FluidLiquid liquid = null)
        {
            SerializedProperty look = edited.FindProperty("look");
            var hidden = new List<string> { "m_Script" };
            if (liquid != null) hidden.AddRange(new[] { "surface", "look", "water", "color", "smoothness" });
            else if (!look.hasMultipleDifferentValues) hidden = Hidden((FluidSurfaceLook)look.enumValueIndex).ToList();
            if (!Array.Exists(edited.targetObjects, t => SimulationLiquid(t) != null)) hidden.Add("ownLook");
            return hidden.ToArray();
        }

        /// <summary>Fields that a look does not read, and the script's own.</summary>
        /// <param name="look">The look.</param>
        /// <returns>Names of serialised fields.</returns>
        public static string[] Hidden(FluidSurfaceLook look) =>
            look == FluidSurfaceLook.Water ? new[] { "m_Script", "color", "smoothness" } : new[] { "m_Script", "water" };

        private static FluidLiquid LiquidOf(Object[] drawn) => Array.Exists(drawn, t => ((FluidSurfaceRenderer)t).OwnLook) ? null
            : FluidInspector.LiquidOf(Array.ConvertAll(drawn, t => ((FluidSurfaceRenderer)t).Simulation));

        private static FluidLiquid SimulationLiquid(Object drawn)
        {
            FluidSimulation simulation = ((FluidSurfaceRenderer)drawn).Simulation;
            return simulation != null ? simulation.ActiveLiquid : null;
        }
    }
}
