using System;

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
    }

    public string name { get; set; } = "";
    public bool wordWrap { get; set; }
    public bool richText { get; set; }
    public int fontSize { get; set; }
    public float fixedWidth { get; set; }
    public float fixedHeight { get; set; }
    public float lineHeight => 15f;
}
