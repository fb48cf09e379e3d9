using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Boxes of domains and liquid volumes in the Scene view.</summary>
    internal static class FluidGizmos
    {
        public static readonly Color DomainColor = new Color(0.35f, 0.75f, 1f, 1f);
        public static readonly Color VolumeColor = new Color(0.1f, 0.4f, 1f, 1f);
        const float Faint = 0.4f;
        const float Fill = 0.12f;

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawDomain(FluidSimulation simulation, GizmoType type)
        {
            Color color = DomainColor;
            if ((type & GizmoType.Selected) == 0) color.a = Faint;
            Gizmos.matrix = simulation.LocalToWorld;
            Gizmos.color = color;
            Gizmos.DrawWireCube(Vector3.zero, simulation.DomainSize);
            FaceGizmos.Draw(simulation.Boundaries, simulation.DomainSize, color.a);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        static void DrawVolume(FluidVolume volume, GizmoType type)
        {
            bool selected = (type & GizmoType.Selected) != 0;
            Color color = VolumeColor;
            Gizmos.matrix = volume.transform.localToWorldMatrix;
            color.a = selected ? 1f : Faint;
            Gizmos.color = color;
            Gizmos.DrawWireCube(Vector3.zero, volume.Size);
            color.a = Fill;
            Gizmos.color = color;
            if (!Application.isPlaying) Gizmos.DrawCube(Vector3.zero, volume.Size);
        }
    }
}
