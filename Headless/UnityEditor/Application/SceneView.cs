using UnityEngine;

namespace UnityEditor;

/// <summary>The Scene window. None is open, as in Unity's batch mode.</summary>
public class SceneView : SearchableEditorWindow
{
    public static SceneView lastActiveSceneView => null!;

    public Vector3 pivot { get; set; }

    public static void RepaintAll() { }
}
