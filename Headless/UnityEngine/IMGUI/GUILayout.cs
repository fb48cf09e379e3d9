namespace UnityEngine;

/// <summary>See <see cref="GUI"/>: nothing is drawn and no button is ever pressed.</summary>
public class GUILayout
{
    static readonly GUILayoutOption s_Option = new();

    public static void Label(string text, params GUILayoutOption[] options) { }
    public static void Label(string text, GUIStyle style, params GUILayoutOption[] options) { }
    public static void Label(GUIContent content, params GUILayoutOption[] options) { }
    public static void Label(Texture image, params GUILayoutOption[] options) { }
    public static bool Button(string text, params GUILayoutOption[] options) => false;
    public static bool Button(string text, GUIStyle style, params GUILayoutOption[] options) => false;
    public static bool Button(GUIContent content, params GUILayoutOption[] options) => false;
    public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => value;
    public static bool Toggle(bool value, GUIContent content, params GUILayoutOption[] options) => value;
    public static float HorizontalSlider(float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
    public static string TextField(string text, params GUILayoutOption[] options) => text;
    public static void Space(float pixels) { }
    public static void FlexibleSpace() { }
    public static void BeginHorizontal(params GUILayoutOption[] options) { }
    public static void BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) { }
    public static void EndHorizontal() { }
    public static void BeginVertical(params GUILayoutOption[] options) { }
    public static void BeginVertical(GUIStyle style, params GUILayoutOption[] options) { }
    public static void EndVertical() { }
    public static void BeginArea(Rect screenRect) { }
    public static void EndArea() { }
    public static GUILayoutOption Width(float width) => s_Option;
    public static GUILayoutOption MinWidth(float minWidth) => s_Option;
    public static GUILayoutOption MaxWidth(float maxWidth) => s_Option;
    public static GUILayoutOption Height(float height) => s_Option;
    public static GUILayoutOption MinHeight(float minHeight) => s_Option;
    public static GUILayoutOption MaxHeight(float maxHeight) => s_Option;
    public static GUILayoutOption ExpandWidth(bool expand) => s_Option;
    public static GUILayoutOption ExpandHeight(bool expand) => s_Option;

    public class HorizontalScope : GUI.Scope
    {
        public HorizontalScope(params GUILayoutOption[] options) => BeginHorizontal(options);
        public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) => BeginHorizontal(style, options);

        protected override void CloseScope() => EndHorizontal();
    }

    public class VerticalScope : GUI.Scope
    {
        public VerticalScope(params GUILayoutOption[] options) => BeginVertical(options);
        public VerticalScope(GUIStyle style, params GUILayoutOption[] options) => BeginVertical(style, options);

        protected override void CloseScope() => EndVertical();
    }
}
