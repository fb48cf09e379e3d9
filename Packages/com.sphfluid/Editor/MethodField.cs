using System;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>The list of methods in the inspector: Automatic first, those to compare with last.</summary>
    internal static class MethodField
    {
        /// <summary>The methods that there are, in the order of the list.</summary>
        public static FluidMethodKind[] Kinds =>
            new[] { FluidMethodKind.Automatic }.Concat(FluidMethods.All.Select(m => m.Kind)).ToArray();

        /// <summary>Draws the list.</summary>
        public static void Draw(SerializedProperty method)
        {
            FluidMethodKind[] kinds = Kinds;
            string[] names = Array.ConvertAll(kinds, k => ObjectNames.NicifyVariableName(k.ToString()));
            Rect place = EditorGUILayout.GetControlRect();
            using (var scope = new EditorGUI.PropertyScope(place, FluidInspector.Label(method), method))
            {
                EditorGUI.BeginChangeCheck();
                EditorGUI.showMixedValue = method.hasMultipleDifferentValues;
                place = EditorGUI.PrefixLabel(place, scope.content);
                int chosen = EditorGUI.Popup(place, Array.IndexOf(kinds, (FluidMethodKind)method.intValue), names);
                EditorGUI.showMixedValue = false;
                if (EditorGUI.EndChangeCheck()) method.intValue = (int)kinds[chosen];
            }
        }
    }
}
