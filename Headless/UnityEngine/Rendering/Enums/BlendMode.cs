namespace UnityEngine.Rendering;

public enum BlendMode
{
    Zero = 0,
    One = 1,
    DstColor = 2,
    SrcColor = 3,
    OneMinusDstColor = 4,
    SrcAlpha = 5,
    OneMinusSrcColor = 6,
    DstAlpha = 7,
    OneMinusDstAlpha = 8,
    SrcAlphaSaturate = 9,
    OneMinusSrcAlpha = 10,
}
