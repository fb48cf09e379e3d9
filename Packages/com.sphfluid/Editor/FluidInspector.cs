using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Fields of an inspector, with their units in the labels.</summary>
    internal static class FluidInspector
    {
        private const BindingFlags Fields = BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public |
            BindingFlags.DeclaredOnly;

        /// <summary>Draws the fields of the edited objects, in their order.</summary>
        /// <param name="edited">The objects.</param>
        /// <param name="hidden">Fields to leave out, besides the script's own.</param>
        public static void Draw(SerializedObject edited, params string[] hidden)
        {
            foreach (string field in Visible(edited, hidden)) DrawField(edited, field);
        }

        /// <summary>Draws one field.</summary>
        public static void DrawField(SerializedObject edited, string field)
        {
            SerializedProperty property = edited.FindProperty(field);
            EditorGUILayout.PropertyField(property, Label(property), true);
        }

        /// <summary>Names of the fields that are shown, in their order.</summary>
        public static List<string> Visible(SerializedObject edited, ICollection<string> hidden)
        {
            var visible = new List<string>();
            SerializedProperty property = edited.GetIterator();
            for (bool enters = true; property.NextVisible(enters); enters = false)
                if (property.name != "m_Script" && !hidden.Contains(property.name)) visible.Add(property.name);
            return visible;
        }

        /// <summary>A field's name, its unit and its tooltip.</summary>
        public static GUIContent Label(SerializedProperty property)
        {
            FieldInfo field = FieldOf(property.serializedObject.targetObject.GetType(), property.name);
            string unit = field?.GetCustomAttribute<UnitAttribute>()?.Symbol;
            return new GUIContent(unit == null ? property.displayName : $"{property.displayName} ({unit})",
                field?.GetCustomAttribute<TooltipAttribute>()?.tooltip);
        }

        /// <summary>The liquid that all of some simulations are of; null where they differ, or one has none.</summary>
        public static FluidLiquid LiquidOf(FluidSimulation[] simulations)
        {
            FluidLiquid liquid = simulations[0] != null ? simulations[0].ActiveLiquid : null;
            return Array.TrueForAll(simulations, s => s != null && s.ActiveLiquid == liquid) ? liquid : null;
        }

        private static FieldInfo FieldOf(Type type, string name)
        {
            for (; type != null; type = type.BaseType)
                if (type.GetField(name, Fields) is FieldInfo found) return found;
            return null;
        }
    }
}
