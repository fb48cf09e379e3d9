using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The sprite of a particle when no other is given: a white disc that fills its square, opaque inside, clear outside.
    /// </summary>
    internal static class RoundSprite
    {
        public const int Size = 64;

        // Share of the radius over which the rim darkens and the alpha falls, about two texels.
        private const float Rim = 0.06f;

        public static Texture2D Create()
        {
            var texture = new Texture2D(Size, Size, TextureFormat.RGBA32, true)
            {
                name = "SPH Fluid round sprite",
                hideFlags = HideFlags.HideAndDontSave,
                wrapMode = TextureWrapMode.Clamp,
                filterMode = FilterMode.Bilinear,
            };
            var pixels = new Color32[Size * Size];
            for (int y = 0; y < Size; y++)
            {
                for (int x = 0; x < Size; x++) pixels[y * Size + x] = Pixel((x + 0.5f) / Size * 2f - 1f, (y + 0.5f) / Size * 2f - 1f);
            }
            texture.SetPixels32(pixels);
            texture.Apply(true, true);
            return texture;
        }

        // Alpha is a half at the unit circle, where the shader cuts.
        private static Color32 Pixel(float x, float y)
        {
            float inside = 1f - Mathf.Sqrt(x * x + y * y);
            byte alpha = (byte)(255f * Mathf.Clamp01(0.5f + inside / Rim));
            byte shade = (byte)(255f * Mathf.Lerp(0.8f, 1f, Mathf.Clamp01(inside / Rim)));
            return new Color32(shade, shade, shade, alpha);
        }
    }
}
