using System;

namespace UnityEngine;

public partial struct Color
{
    public static void RGBToHSV(Color rgbColor, out float H, out float S, out float V)
    {
        float max = rgbColor.maxColorComponent;
        float min = Mathf.Min(Mathf.Min(rgbColor.r, rgbColor.g), rgbColor.b);
        float chroma = max - min;
        V = max;
        S = max == 0f ? 0f : chroma / max;
        if (chroma == 0f)
        {
            H = 0f;
            return;
        }
        float sector = max == rgbColor.r ? (rgbColor.g - rgbColor.b) / chroma
            : max == rgbColor.g ? 2f + (rgbColor.b - rgbColor.r) / chroma
            : 4f + (rgbColor.r - rgbColor.g) / chroma;
        H = sector / 6f;
        if (H < 0f) H += 1f;
    }

    public static Color HSVToRGB(float H, float S, float V) => HSVToRGB(H, S, V, true);

    public static Color HSVToRGB(float H, float S, float V, bool hdr)
    {
        float sector = H * 6f;
        int index = (int)MathF.Floor(sector);
        float f = sector - index;
        float p = V * (1f - S), q = V * (1f - S * f), t = V * (1f - S * (1f - f));
        Color color = (((index % 6) + 6) % 6) switch
        {
            0 => new Color(V, t, p),
            1 => new Color(q, V, p),
            2 => new Color(p, V, t),
            3 => new Color(p, q, V),
            4 => new Color(t, p, V),
            _ => new Color(V, p, q),
        };
        return hdr ? color : new Color(Mathf.Clamp01(color.r), Mathf.Clamp01(color.g), Mathf.Clamp01(color.b));
    }
}
