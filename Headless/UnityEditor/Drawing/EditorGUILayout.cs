using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>See <see cref="EditorGUI"/>.</summary>
public sealed class EditorGUILayout
{
    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options) => PropertyField(property, null, true, options);
    public static bool PropertyField(SerializedProperty property, GUIContent? label, params GUILayoutOption[] options) => PropertyField(property, label, true, options);
    public static bool PropertyField(SerializedProperty property, bool includeChildren, params GUILayoutOption[] options) => PropertyField(property, null, includeChildren, options);

    public static bool PropertyField(SerializedProperty property, GUIContent? label, bool includeChildren, params GUILayoutOption[] options)
    {
        ArgumentNullException.ThrowIfNull(property);
        return property.isExpanded;
    }

    public static void HelpBox(string message, MessageType type) { }
    public static void HelpBox(string message, MessageType type, bool wide) { }
    public static void LabelField(string label, params GUILayoutOption[] options) { }
    public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options) { }
    public static void LabelField(string label, string label2, params GUILayoutOption[] options) { }
    public static void LabelField(string label, string label2, GUIStyle style, params GUILayoutOption[] options) { }
    public static void LabelField(GUIContent label, params GUILayoutOption[] options) { }
    public static Rect GetControlRect(params GUILayoutOption[] options) => default;
    public static void Space() { }
    public static void Space(float width) { }
    public static Object ObjectField(string label, Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) => obj;
    public static Object ObjectField(Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) => obj;
    public static float FloatField(string label, float value, params GUILayoutOption[] options) => value;
    public static int IntField(string label, int value, params GUILayoutOption[] options) => value;
    public static bool Toggle(string label, bool value, params GUILayoutOption[] options) => value;
    public static float Slider(string label, float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
    public static int IntSlider(string label, int value, int leftValue, int rightValue, params GUILayoutOption[] options) => value;
    public static Vector3 Vector3Field(string label, Vector3 value, params GUILayoutOption[] options) => value;
    public static string TextField(string label, string text, params GUILayoutOption[] options) => text;
    public static int Popup(string label, int selectedIndex, string[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
    public static Enum EnumPopup(string label, Enum selected, params GUILayoutOption[] options) => selected;
    public static bool Foldout(bool foldout, string content) => foldout;
    public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => foldout;
    public static Rect BeginHorizontal(params GUILayoutOption[] options) => default;
    public static Rect BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) => default;
    public static void EndHorizontal() { }
    public static Rect BeginVertical(params GUILayoutOption[] options) => default;
    public static Rect BeginVertical(GUIStyle style, params GUILayoutOption[] options) => default;
    public static void EndVertical() { }

    public class HorizontalScope : GUI.Scope
    {
        public HorizontalScope(params GUILayoutOption[] options) => rect = BeginHorizontal(options);
        public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) => rect = BeginHorizontal(style, options);

        public Rect rect { get; protected set; }

        protected override void CloseScope() => EndHorizontal();
    }

    public class VerticalScope : GUI.Scope
    {
        public VerticalScope(params GUILayoutOption[] options) => rect = BeginVertical(options);
        public VerticalScope(GUIStyle style, params GUILayoutOption[] options) => rect = BeginVertical(style, options);

        public Rect rect { get; protected set; }

        protected override void CloseScope() => EndVertical();
    }
}
