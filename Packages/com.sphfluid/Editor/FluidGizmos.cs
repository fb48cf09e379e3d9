using UnityEditor;
using UnityEngine;

namespace SphFluid.Editor
{
    /// <summary>Domains and liquid volumes in the Scene view.</summary>
    internal static class FluidGizmos
    {
        public static readonly Color DomainColor = new Color(0.35f, 0.75f, 1f, 1f);
        public static readonly Color VolumeColor = new Color(0.1f, 0.4f, 1f, 1f);
        public static readonly Color DrainColor = new Color(1f, 0.55f, 0.1f, 1f);
        public static readonly Color ZoneColor = new Color(0.55f, 0.9f, 0.35f, 1f);
        public static readonly Color SensorColor = new Color(1f, 0.9f, 0.3f, 1f);
        private const float SensorSize = 0.03f; // m
        private const float Faint = 0.4f;
        private const float Fill = 0.12f;

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawDomain(FluidSimulation simulation, GizmoType type)
        {
            Color color = DomainColor;
            if ((type & GizmoType.Selected) == 0) color.a = Faint;
            Gizmos.matrix = simulation.LocalToWorld;
            Gizmos.color = color;
            Gizmos.DrawWireCube(Vector3.zero, simulation.DomainSize);
            if (simulation.Domain == FluidDomain.Box) FaceGizmos.Draw(simulation.Boundaries, simulation.DomainSize, color.a);
            if ((type & GizmoType.Selected) == 0) return;
            FillGizmos.Draw(simulation);
            SleepGizmos.Draw(simulation);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawVolume(FluidVolume volume, GizmoType type)
        {
            bool selected = (type & GizmoType.Selected) != 0;
            Color color = VolumeColor;
            Gizmos.matrix = volume.transform.localToWorldMatrix;
            color.a = selected ? 1f : Faint;
            Gizmos.color = color;
            DrawShape(volume, false);
            color.a = Fill;
            Gizmos.color = color;
            if (!Application.isPlaying) DrawShape(volume, true);
            if (selected) FillGizmos.Draw(OwnerOf(volume));
        }

        /// <summary>The simulation that a volume belongs to; null for none.</summary>
        internal static FluidSimulation OwnerOf(FluidVolume volume) => FluidScene.Owner(volume, SceneObjects.Find<FluidSimulation>(volume));

        /// <summary>Whether a shape is as large as its volume's Size says.</summary>
        internal static bool HasSize(FluidVolumeShape shape) => shape == FluidVolumeShape.Box || shape == FluidVolumeShape.Sphere;

        private static void DrawShape(FluidVolume volume, bool solid)
        {
            switch (volume.Shape)
            {
                case FluidVolumeShape.Box:
                    if (solid) Gizmos.DrawCube(Vector3.zero, volume.Size);
                    else Gizmos.DrawWireCube(Vector3.zero, volume.Size);
                    break;
                case FluidVolumeShape.Sphere:
                    Gizmos.matrix = volume.transform.localToWorldMatrix * Matrix4x4.Scale(volume.Size);
                    if (solid) Gizmos.DrawSphere(Vector3.zero, 0.5f);
                    else Gizmos.DrawWireSphere(Vector3.zero, 0.5f);
                    break;
                case FluidVolumeShape.Mesh:
                    Mesh mesh = volume.FilledMesh;
                    if (mesh == null) break;
                    if (solid) Gizmos.DrawMesh(mesh);
                    else Gizmos.DrawWireMesh(mesh);
                    break;
                case FluidVolumeShape.Vessel:
                    if (!solid) DrawLevel(volume);
                    break;
            }
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawEmitter(FluidEmitter emitter, GizmoType type)
        {
            EmitterSpec spec = emitter.Spec;
            Color color = VolumeColor;
            color.a = (type & GizmoType.Selected) != 0 ? 1f : Faint;
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.TRS(spec.Position, spec.Rotation, Vector3.one);
            float arrow = Mathf.Max(spec.Size.x, spec.Size.y);
            Gizmos.DrawLine(Vector3.zero, new Vector3(0f, 0f, arrow));
            Gizmos.DrawLine(new Vector3(0f, 0f, arrow), new Vector3(0.15f * arrow, 0f, 0.75f * arrow));
            Gizmos.DrawLine(new Vector3(0f, 0f, arrow), new Vector3(-0.15f * arrow, 0f, 0.75f * arrow));
            if (spec.UnderWater) DrawPipe(emitter, spec);
            if (spec.Shape == FluidEmitterShape.Disc) DrawEllipse(0.5f * spec.Size);
            else if (spec.Shape == FluidEmitterShape.Mesh &&
                spec.Mesh != null) Gizmos.DrawWireMesh(spec.Mesh, Vector3.zero, Quaternion.identity, spec.Scale);
            else Gizmos.DrawWireCube(Vector3.zero, new Vector3(spec.Size.x, spec.Shape == FluidEmitterShape.Line ? 0f : spec.Size.y, 0f));
        }

        private static void DrawEllipse(Vector2 half)
        {
            const int sides = 32;
            var last = new Vector3(half.x, 0f, 0f);
            for (int i = 1; i <= sides; i++)
            {
                float angle = 2f * Mathf.PI * i / sides;
                var next = new Vector3(half.x * Mathf.Cos(angle), half.y * Mathf.Sin(angle), 0f);
                Gizmos.DrawLine(last, next);
                last = next;
            }
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawDrain(FluidDrain drain, GizmoType type)
        {
            DrainSpec spec = drain.Spec;
            Color color = DrainColor;
            color.a = (type & GizmoType.Selected) != 0 ? 1f : Faint;
            Gizmos.color = color;
            Gizmos.matrix = spec.Frame;
            if (spec.IsBox)
            {
                Gizmos.DrawWireCube(Vector3.zero, 2f * Vector3.one);
                return;
            }
            Gizmos.DrawWireSphere(new Vector3(0f, spec.Length, 0f), 1f);
            if (spec.Length > 0f) Gizmos.DrawWireSphere(new Vector3(0f, -spec.Length, 0f), 1f);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawZone(FluidForceZone zone, GizmoType type)
        {
            ZoneSpec spec = zone.Spec;
            Color color = ZoneColor;
            color.a = (type & GizmoType.Selected) != 0 ? 1f : Faint;
            Gizmos.color = color;
            if (spec.Shape == FluidZoneShape.Collider) return; // there is none
            Gizmos.matrix = Matrix4x4.TRS(spec.Position, spec.Rotation * spec.ShapeTurn, Vector3.one);
            float radius = 0.5f * spec.Size.x, reach = Mathf.Max(0f, 0.5f * spec.Size.y - radius);
            if (spec.Shape == FluidZoneShape.Box) Gizmos.DrawWireCube(Vector3.zero, spec.Size);
            else if (spec.Shape == FluidZoneShape.Sphere) Gizmos.DrawWireSphere(Vector3.zero, radius);
            else
            {
                Gizmos.DrawWireSphere(new Vector3(0f, reach, 0f), radius);
                Gizmos.DrawWireSphere(new Vector3(0f, -reach, 0f), radius);
            }
            float arrow = 0.5f * spec.Size.z;
            Gizmos.matrix = Matrix4x4.TRS(spec.Position, spec.Rotation, Vector3.one);
            if (spec.Kind == FluidForceKind.Directional || spec.Kind == FluidForceKind.Wind)
            {
                Gizmos.DrawLine(Vector3.zero, new Vector3(0f, 0f, arrow));
            }
            if (spec.Kind == FluidForceKind.Vortex) Gizmos.DrawLine(new Vector3(0f, -arrow, 0f), new Vector3(0f, arrow, 0f));
        }

        // The wall that liquid collides with, for the simulation that the emitter belongs to.
        private static void DrawPipe(FluidEmitter emitter, in EmitterSpec spec)
        {
            FluidSimulation owner = FluidScene.Owner(emitter, emitter.Simulation, SceneObjects.Find<FluidSimulation>(emitter));
            if (owner == null || EmitterChecks.Check(spec, owner.Spec) != null) return;
            Bounds wall = EmitterPipe.Create(spec, owner.Spacing, owner.Spec.SupportRadius).Mesh.Bounds;
            Gizmos.DrawWireCube(wall.center, wall.size);
        }

        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected | GizmoType.Pickable)]
        private static void DrawSensor(FluidSensor sensor, GizmoType type)
        {
            Color color = SensorColor;
            color.a = (type & GizmoType.Selected) != 0 || sensor.IsAbove ? 1f : Faint;
            Gizmos.color = color;
            Gizmos.matrix = Matrix4x4.TRS(sensor.transform.position, sensor.transform.rotation, Vector3.one);
            Gizmos.DrawWireSphere(Vector3.zero, SensorSize);
            if (sensor.Kind == FluidSensorKind.FillLevel) Gizmos.DrawWireCube(Vector3.zero, sensor.Size);
            if (sensor.Kind != FluidSensorKind.Level) return;
            Gizmos.DrawLine(Vector3.zero, new Vector3(0f, sensor.Length, 0f));
            Gizmos.DrawWireCube(new Vector3(0f, sensor.Threshold, 0f), new Vector3(2f * SensorSize, 0f, 2f * SensorSize));
            if (sensor.HasValue) Gizmos.DrawWireSphere(new Vector3(0f, sensor.Value, 0f), 0.5f * SensorSize);
        }

        // The point that the vessel is filled round, and the height of the surface above it.
        private static void DrawLevel(FluidVolume volume)
        {
            FluidSimulation owner = volume.Simulation != null ? volume.Simulation : volume.GetComponentInParent<FluidSimulation>();
            Vector3 gravity = owner != null ? owner.EffectiveGravity : Physics.gravity;
            Vector3 up = gravity.sqrMagnitude > 0f ? -gravity.normalized : Vector3.up;
            float mark = 0.25f * volume.Level;
            Gizmos.matrix = Matrix4x4.TRS(volume.transform.position, Quaternion.FromToRotation(Vector3.up, up), Vector3.one);
            Gizmos.DrawLine(Vector3.zero, new Vector3(0f, volume.Level, 0f));
            Gizmos.DrawWireCube(new Vector3(0f, volume.Level, 0f), new Vector3(mark, 0f, mark));
        }
    }
}
