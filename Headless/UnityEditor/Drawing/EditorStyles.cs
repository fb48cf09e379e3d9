using UnityEngine;

namespace UnityEditor;

public sealed class EditorStyles
{
    public static GUIStyle label { get; } = new() { name = "Label" };
    public static GUIStyle boldLabel { get; } = new() { name = "BoldLabel" };
    public static GUIStyle miniLabel { get; } = new() { name = "MiniLabel" };
    public static GUIStyle helpBox { get; } = new() { name = "HelpBox" };
    public static GUIStyle foldout { get; } = new() { name = "Foldout" };
}
