using System;

namespace UnityEngine;

[Serializable]
public sealed class GUIStyleState
{
    public GUIStyleState() { }

    public Color textColor { get; set; } = Color.black;
}
