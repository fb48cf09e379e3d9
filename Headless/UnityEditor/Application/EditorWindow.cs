using UnityEngine;

namespace UnityEditor;

/// <summary>A window of the Editor; there are none here.</summary>
public class EditorWindow : ScriptableObject
{
    public static T GetWindow<T>(string title) where T : EditorWindow
    {
        foreach (T open in Resources.FindObjectsOfTypeAll<T>())
            return open;
        T window = CreateInstance<T>();
        window.name = title;
        return window;
    }

    public void Repaint() { }
}
