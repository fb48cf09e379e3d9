using System;

namespace UnityEngine;

/// <summary>No window, no input: controls draw nothing and return what they were given.</summary>
public class GUI
{
    public static bool enabled { get; set; } = true;
    public static bool changed { get; set; }
    public static Color color { get; set; } = Color.white;
    public static Color backgroundColor { get; set; } = Color.white;
    public static Color contentColor { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
    public static int depth { get; set; }

    internal GUI() { }

    public static void Label(Rect position, string text) { }
    public static void Label(Rect position, string text, GUIStyle style) { }
    public static void Label(Rect position, GUIContent content) { }
    public static void Box(Rect position, GUIContent content) { }
    public static bool Button(Rect position, string text) => false;
    public static bool Button(Rect position, GUIContent content) => false;
    public static bool Toggle(Rect position, bool value, GUIContent content) => value;

    public abstract class Scope : IDisposable
    {
        bool m_Disposed;

        protected Scope() { }

        protected abstract void CloseScope();

        public void Dispose()
        {
            if (m_Disposed) return;
            m_Disposed = true;
            CloseScope();
        }
    }
}
