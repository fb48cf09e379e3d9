using System;

namespace UnityEngine;

/// <summary>Scene view drawing, which does not exist here: state is kept, shapes are dropped.</summary>
public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
    public static float probeSize => 0.1f;

    public static void DrawLine(Vector3 from, Vector3 to) { }
    public static void DrawLineList(ReadOnlySpan<Vector3> points) { }
    public static void DrawLineStrip(ReadOnlySpan<Vector3> points, bool looped) { }
    public static void DrawRay(Ray r) { }
    public static void DrawRay(Vector3 from, Vector3 direction) { }
    public static void DrawCube(Vector3 center, Vector3 size) { }
    public static void DrawWireCube(Vector3 center, Vector3 size) { }
    public static void DrawSphere(Vector3 center, float radius) { }
    public static void DrawWireSphere(Vector3 center, float radius) { }
    public static void DrawFrustum(Vector3 center, float fov, float maxRange, float minRange, float aspect) { }
    public static void DrawIcon(Vector3 center, string name) { }
    public static void DrawIcon(Vector3 center, string name, bool allowScaling) { }
    public static void DrawIcon(Vector3 center, string name, bool allowScaling, Color tint) { }
    public static void DrawMesh(Mesh mesh) { }
    public static void DrawMesh(Mesh mesh, Vector3 position) { }
    public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation) { }
    public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Vector3 scale) { }
    public static void DrawWireMesh(Mesh mesh) { }
    public static void DrawWireMesh(Mesh mesh, Vector3 position) { }
    public static void DrawWireMesh(Mesh mesh, Vector3 position, Quaternion rotation) { }
    public static void DrawWireMesh(Mesh mesh, Vector3 position, Quaternion rotation, Vector3 scale) { }
}
