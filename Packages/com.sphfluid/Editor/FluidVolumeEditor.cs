using System.Collections.Generic;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Inspector of a liquid volume: the fields of its shape, and a handle for its box.</summary>
    [CustomEditor(typeof(FluidVolume)), CanEditMultipleObjects]
    public sealed class FluidVolumeEditor : UnityEditor.Editor
    {
        private readonly BoxBoundsHandle handle = new BoxBoundsHandle();
        private FluidSimulation owner;
        private ValidationGUI validation;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidInspector.Draw(serializedObject, Hidden());
            serializedObject.ApplyModifiedProperties();
            if (targets.Length == 1) DrawOwner((FluidVolume)target);
            else EditorGUILayout.HelpBox("Select one volume to see its messages.", MessageType.None);
        }

        private void OnDisable() => Watch(null);

        private void Watch(FluidSimulation now)
        {
            if (validation == null ? now == null : ReferenceEquals(now, owner)) return;
            validation?.Dispose();
            owner = now;
            validation = now != null ? new ValidationGUI(now) : null;
        }

        private string[] Hidden()
        {
            SerializedProperty property = serializedObject.FindProperty("shape");
            var hidden = new List<string> { "m_Script" };
            if (property.hasMultipleDifferentValues) return hidden.ToArray();
            var shape = (FluidVolumeShape)property.enumValueIndex;
            if (!FluidGizmos.HasSize(shape)) hidden.Add("size");
            if (shape != FluidVolumeShape.Mesh) hidden.Add("mesh");
            if (shape != FluidVolumeShape.Vessel) hidden.AddRange(new[] { "level", "domainHolds" });
            return hidden.ToArray();
        }

        private void OnSceneGUI()
        {
            var volume = (FluidVolume)target;
            if (!FluidGizmos.HasSize(volume.Shape)) return;
            using (new Handles.DrawingScope(FluidGizmos.VolumeColor, volume.transform.localToWorldMatrix))
            {
                handle.center = Vector3.zero;
                handle.size = volume.Size;
                EditorGUI.BeginChangeCheck();
                handle.DrawHandle();
                if (!EditorGUI.EndChangeCheck()) return;
                Undo.RecordObjects(new Object[] { volume, volume.transform }, "Change Fluid Volume");
                volume.transform.position = volume.transform.TransformPoint(handle.center);
                volume.Size = handle.size;
            }
        }

        private void DrawOwner(FluidVolume volume)
        {
            if (Event.current.type == EventType.Layout) Watch(FluidGizmos.OwnerOf(volume));
            if (owner == null && SceneObjects.IsPrefabAsset(volume))
                EditorGUILayout.HelpBox("This is a prefab asset: the simulation that it belongs to is found once it is in a scene.",
                    MessageType.Info);
            else if (owner == null)
                EditorGUILayout.HelpBox("No simulation's domain holds this liquid. Make it a child of a Fluid Simulation or assign one.",
                    MessageType.Warning);
            else
            {
                using (new EditorGUI.DisabledScope(true))
                    EditorGUILayout.ObjectField("Belongs to", owner, typeof(FluidSimulation), true);
                validation.Draw(volume);
                if (Application.isPlaying) DrawDifference(volume);
                else if (FillGizmos.Text(validation.Memory) is string text) EditorGUILayout.HelpBox(text, MessageType.None);
            }
        }

        private void DrawDifference(FluidVolume volume)
        {
            if (!(owner.DifferenceOf(volume) is FluidMessage message)) return;
            EditorGUILayout.HelpBox($"'{message.Source}': {message.Text} {message.Cure}", MessageType.Info);
            using (new EditorGUILayout.HorizontalScope())
            {
                GUILayout.FlexibleSpace();
                if (owner.Solver.Exchanges && GUILayout.Button("Add Its Liquid", GUILayout.Width(110f))) owner.AddLiquid(volume);
                if (GUILayout.Button("Restart", GUILayout.Width(80f))) owner.ResetSimulation();
            }
        }
    }
}
