using System;
using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>Inspector of whitewater: the fields that act beside the simulation's liquid.</summary>
    [CustomEditor(typeof(FluidWhitewater)), CanEditMultipleObjects]
    public sealed class FluidWhitewaterEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidLiquid liquid = Array.Exists(targets, t => ((FluidWhitewater)t).OwnLook) ? null
                : FluidInspector.LiquidOf(Array.ConvertAll(targets, t => ((FluidWhitewater)t).GetComponent<FluidSimulation>()));
            FluidInspector.Draw(serializedObject, liquid == null ? new string[0] : new[] { "amount", "foamLife", "size", "color" });
            serializedObject.ApplyModifiedProperties();
            if (liquid == null) return;
            EditorGUILayout.HelpBox(liquid.Whitewater ? $"Foam and spray are those of '{liquid.name}'."
                : $"'{liquid.name}' makes no whitewater. Switch Own Look on to have some.", MessageType.Info);
        }
    }
}
