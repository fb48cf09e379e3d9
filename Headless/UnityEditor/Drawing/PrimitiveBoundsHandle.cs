using UnityEngine;

namespace UnityEditor.IMGUI.Controls;

public abstract class PrimitiveBoundsHandle
{
    Vector3 m_Size;

    public PrimitiveBoundsHandle() { }

    public Vector3 center { get; set; }
    public Color handleColor { get; set; } = Color.white;
    public Color wireframeColor { get; set; } = Color.white;

    public void DrawHandle() => DrawWireframe();

    public void SetColor(Color color)
    {
        handleColor = color;
        wireframeColor = color;
    }

    protected abstract void DrawWireframe();
    protected Vector3 GetSize() => m_Size;
    protected void SetSize(Vector3 size) => m_Size = Vector3.Max(size, Vector3.zero);
}
