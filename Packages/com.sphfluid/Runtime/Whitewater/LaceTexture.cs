using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What flakes of foam are cut out of: a film of cells (Worley 1996, "A cellular texture basis function"), dense at their rims. It
    /// repeats.
    /// </summary>
    internal static class LaceTexture
    {
        public const int Size = 128;

        // Cells along a side, and of what remains of the film in the middle of one.
        private const int Cells = 10;
        private const float Thinnest = 0.3f;

        // Width of a rim in cells.
        private const float Rim = 0.45f;

        public static Texture2D Create()
        {
            var texture = new Texture2D(Size, Size, TextureFormat.RGBA32, false, true)
            {
                name = "SPH Fluid lace",
                hideFlags = HideFlags.HideAndDontSave,
                wrapMode = TextureWrapMode.Repeat,
                filterMode = FilterMode.Bilinear,
            };
            Vector2[] centres = Centres();
            var pixels = new Color32[Size * Size];
            for (int i = 0; i < pixels.Length; i++)
            {
                float density = Density(new Vector2(i % Size + 0.5f, i / Size + 0.5f) * ((float)Cells / Size), centres);
                var value = (byte)Math.Round(255f * density);
                pixels[i] = new Color32(value, value, value, 255);
            }
            texture.SetPixels32(pixels);
            texture.Apply(false, true);
            return texture;
        }

        // One in each square of a grid, away from its edges.
        private static Vector2[] Centres()
        {
            var random = new System.Random(1);
            var centres = new Vector2[Cells * Cells];
            for (int i = 0; i < centres.Length; i++)
            {
                float x = (float)random.NextDouble(), y = (float)random.NextDouble();
                centres[i] = new Vector2(0.1f + 0.8f * x, 0.1f + 0.8f * y);
            }
            return centres;
        }

        // Of the film at a place, in cells: from its two nearest centres.
        private static float Density(Vector2 place, Vector2[] centres)
        {
            float nearest = float.MaxValue, second = float.MaxValue;
            int x = (int)place.x, y = (int)place.y;
            for (int j = y - 1; j <= y + 1; j++)
            {
                for (int i = x - 1; i <= x + 1; i++)
                {
                    Vector2 centre = new Vector2(i, j) + centres[(i + Cells) % Cells + Cells * ((j + Cells) % Cells)];
                    float distance = (centre - place).magnitude;
                    if (distance < nearest) (nearest, second) = (distance, nearest);
                    else second = Math.Min(second, distance);
                }
            }
            float within = Mathf.SmoothStep(0f, 1f, (second - nearest) / Rim);
            return Mathf.Lerp(1f, Thinnest, within);
        }
    }
}
