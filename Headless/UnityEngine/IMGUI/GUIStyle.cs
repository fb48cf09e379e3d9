using System;
using Headless.Engine;

namespace UnityEngine;

[Serializable]
public sealed class GUIStyle
{
    public GUIStyle() { }

    public GUIStyle(GUIStyle other)
    {
        name = other.name;
        wordWrap = other.wordWrap;
        richText = other.richText;
        fontSize = other.fontSize;
        fixedWidth = other.fixedWidth;
        fixedHeight = other.fixedHeight;
        normal = new GUIStyleState { textColor = other.normal.textColor };
    }

    internal static GUIStyle Default { get; } = new() { normal = { textColor = Color.white } };

    public string name { get; set; } = "";
    public bool wordWrap { get; set; }
    public bool richText { get; set; }
    public int fontSize { get; set; }
    public float fixedWidth { get; set; }
    public float fixedHeight { get; set; }
    public GUIStyleState normal { get; set; } = new();
    public float lineHeight => GuiFont.LineHeight(fontSize);

    public Vector2 CalcSize(GUIContent content) => GuiFont.SizeOf(content.text, fontSize);
}
