namespace UnityEngine;

public struct Resolution
{
    public int width { get; set; }
    public int height { get; set; }

    public override string ToString() => $"{width} x {height}";
}
