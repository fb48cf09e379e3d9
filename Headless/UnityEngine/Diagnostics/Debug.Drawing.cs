namespace UnityEngine;

/// <summary>Lines for the Scene view, which this stand-in does not have.</summary>
public partial class Debug
{
    public static void DrawLine(Vector3 start, Vector3 end) { }
    public static void DrawLine(Vector3 start, Vector3 end, Color color) { }
    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration) { }
    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration, bool depthTest) { }
    public static void DrawRay(Vector3 start, Vector3 dir) { }
    public static void DrawRay(Vector3 start, Vector3 dir, Color color) { }
    public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration) { }
    public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration, bool depthTest) { }
}
