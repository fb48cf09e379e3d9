using UnityEngine;

namespace UnityEditor.IMGUI.Controls;

public class BoxBoundsHandle : PrimitiveBoundsHandle
{
    public Vector3 size { get => GetSize(); set => SetSize(value); }

    protected override void DrawWireframe() => Handles.DrawWireCube(center, size);
}
