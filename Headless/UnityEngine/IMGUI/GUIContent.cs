using System;

namespace UnityEngine;

[Serializable]
public class GUIContent
{
    public static GUIContent none = new("");

    public GUIContent() : this("", "") { }
    public GUIContent(string text) : this(text, "") { }

    public GUIContent(string text, string tooltip)
    {
        this.text = text;
        this.tooltip = tooltip;
    }

    public GUIContent(GUIContent src) : this(src.text, src.tooltip) { }

    public string text { get; set; }
    public string tooltip { get; set; }

    public override string ToString() => text ?? tooltip ?? base.ToString()!;
}
