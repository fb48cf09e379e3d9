using System;
using UnityEngine;

namespace UnityEditor;

/// <summary>Scene view drawing, which does not exist here: state is kept, shapes are dropped.</summary>
public sealed class Handles
{
    public static Color color { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 p1, Vector3 p2) { }
    public static void DrawWireCube(Vector3 center, Vector3 size) { }
    public static void Label(Vector3 position, string text) { }
    public static Vector3 PositionHandle(Vector3 position, Quaternion rotation) => position;

    public struct DrawingScope : IDisposable
    {
        bool m_Disposed;

        public DrawingScope(Color color) : this(color, Handles.matrix) { }
        public DrawingScope(Matrix4x4 matrix) : this(Handles.color, matrix) { }

        public DrawingScope(Color color, Matrix4x4 matrix)
        {
            m_Disposed = false;
            originalColor = Handles.color;
            originalMatrix = Handles.matrix;
            Handles.color = color;
            Handles.matrix = matrix;
        }

        public Color originalColor { get; }
        public Matrix4x4 originalMatrix { get; }

        public void Dispose()
        {
            if (m_Disposed) return;
            m_Disposed = true;
            Handles.color = originalColor;
            Handles.matrix = originalMatrix;
        }
    }
}
