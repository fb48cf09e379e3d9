using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Probes, gauges and fluxes in the Scene view, with what they read.</summary>
    internal static class InstrumentGizmos
    {
        private const float MarkSize = 0.02f; // m
        private const float Faint = 0.5f;

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawProbe(FluidProbe probe, GizmoType type)
        {
            Begin(type);
            Vector3 place = probe.transform.position;
            Gizmos.DrawWireSphere(place, MarkSize);
            if (probe.Kind == FluidProbeKind.WallPressure)
            {
                Vector3 wall = probe.WallPoint;
                Gizmos.DrawLine(place, wall);
                Gizmos.matrix = Matrix4x4.TRS(wall, probe.WallRotation, Vector3.one);
                Gizmos.DrawWireCube(Vector3.zero, new Vector3(probe.PatchSize.x, probe.PatchSize.y, 0f));
                Gizmos.DrawLine(Vector3.zero, new Vector3(0f, 0f, 2f * MarkSize));
            }
            else if (probe.Kind == FluidProbeKind.Velocity) Gizmos.DrawLine(place, place + 0.1f * probe.Velocity);
            Label(probe, place);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawGauge(FluidGauge gauge, GizmoType type)
        {
            Begin(type);
            Gizmos.matrix = Matrix4x4.TRS(gauge.transform.position, gauge.transform.rotation, Vector3.one);
            Gizmos.DrawLine(Vector3.zero, new Vector3(0f, gauge.Length, 0f));
            var mark = new Vector3(2f * MarkSize, 0f, 2f * MarkSize);
            Gizmos.DrawWireCube(Vector3.zero, mark);
            Gizmos.DrawWireCube(new Vector3(0f, gauge.Length, 0f), mark);
            if (gauge.HasValue) Gizmos.DrawWireSphere(new Vector3(0f, gauge.Height, 0f), 0.5f * MarkSize);
            Label(gauge, gauge.Surface);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawFlux(FluidFlux flux, GizmoType type)
        {
            Begin(type);
            Gizmos.matrix = Matrix4x4.TRS(flux.transform.position, flux.transform.rotation, Vector3.one);
            Gizmos.DrawWireCube(Vector3.zero, new Vector3(flux.Size.x, flux.Size.y, 0f));
            float arrow = 0.25f * Mathf.Min(flux.Size.x, flux.Size.y);
            Gizmos.DrawLine(Vector3.zero, new Vector3(0f, 0f, arrow));
            Gizmos.DrawLine(new Vector3(0f, 0f, arrow), new Vector3(0.2f * arrow, 0f, 0.8f * arrow));
            Gizmos.DrawLine(new Vector3(0f, 0f, arrow), new Vector3(-0.2f * arrow, 0f, 0.8f * arrow));
            Label(flux, flux.transform.position);
        }

        private static void Begin(GizmoType type)
        {
            Color color = FluidGizmos.SensorColor;
            color.a = (type & GizmoType.Selected) != 0 ? 1f : Faint;
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.identity;
        }

        private static void Label(FluidInstrument instrument, Vector3 place)
        {
            if (instrument.HasValue) Handles.Label(place, $"{instrument.name}\n{InstrumentText.Describe(instrument.Readings[0])}");
            else if (instrument.Problem.HasValue) Handles.Label(place, $"{instrument.name}\nno reading");
        }
    }
}
