using UnityEngine;

namespace UnityEditor;

/// <summary>A window of the Editor; there are none here.</summary>
public class EditorWindow : ScriptableObject
{
    public void Repaint() { }
}
