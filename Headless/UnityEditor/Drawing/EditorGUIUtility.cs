using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class EditorGUIUtility : GUIUtility
{
    public static float singleLineHeight => 18f;
    public static float standardVerticalSpacing => 2f;
    public static float labelWidth { get; set; } = 150f;
    public static float fieldWidth { get; set; } = 50f;

    public static bool editingTextField { get; set; }

    public static void PingObject(Object obj) { }
    public static void PingObject(int targetInstanceID) { }
}
