using System.Linq;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the benchmark drew.</summary>
    internal static class BenchPicture
    {
        public static Color[] Pixels(RenderTexture target)
        {
            var picture = new Texture2D(target.width, target.height, TextureFormat.RGBA32, false);
            RenderTexture before = RenderTexture.active;
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            picture.Apply();
            RenderTexture.active = before;
            Color[] pixels = picture.GetPixels();
            Object.DestroyImmediate(picture);
            return pixels;
        }

        /// <summary>Part of the picture that is not black.</summary>
        public static double Covered(RenderTexture target)
        {
            Color[] pixels = Pixels(target);
            return pixels.Count(c => c.r + c.g + c.b > 0.02f) / (double)pixels.Length;
        }
    }
}
