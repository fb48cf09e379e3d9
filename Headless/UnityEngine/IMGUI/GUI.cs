using System;
using Headless.Engine;

namespace UnityEngine;

/// <summary>No window, no input: controls return what they were given. Of them labels and textures of one colour are drawn, into what is captured of the screen.</summary>
public class GUI
{
    public static bool enabled { get; set; } = true;
    public static bool changed { get; set; }
    public static Color color { get; set; } = Color.white;
    public static Color backgroundColor { get; set; } = Color.white;
    public static Color contentColor { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
    public static int depth { get; set; }

    internal GUI() { }

    public static void Label(Rect position, string text) => Label(position, text, GUIStyle.Default);
    public static void Label(Rect position, string text, GUIStyle style) => GuiPicture.Add(position, text, style);
    public static void Label(Rect position, GUIContent content) => Label(position, content.text, GUIStyle.Default);
    public static void Label(Rect position, GUIContent content, GUIStyle style) => Label(position, content.text, style);

    /// <summary>A flat colour: the image has to be <see cref="Texture2D.whiteTexture"/>; others are not drawn.</summary>
    public static void DrawTexture(Rect position, Texture image, ScaleMode scaleMode) =>
        DrawTexture(position, image, scaleMode, true, 0f, color, 0f, 0f);

    public static void DrawTexture(Rect position, Texture image, ScaleMode scaleMode, bool alphaBlend, float imageAspect, Color color, float borderWidth, float borderRadius)
    {
        if (image == Texture2D.whiteTexture) GuiPicture.Add(position, alphaBlend ? color : new Color(color.r, color.g, color.b, 1f));
    }

    public static void Box(Rect position, GUIContent content) { }
    public static bool Button(Rect position, string text) => false;
    public static bool Button(Rect position, GUIContent content) => false;
    public static bool Toggle(Rect position, bool value, GUIContent content) => value;

    public abstract class Scope : IDisposable
    {
        bool m_Disposed;

        protected Scope() { }

        protected abstract void CloseScope();

        public void Dispose()
        {
            if (m_Disposed) return;
            m_Disposed = true;
            CloseScope();
        }
    }
}
