using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What a camera drew, as its target holds it; row 0 is the lowest.</summary>
    internal sealed class Picture
    {
        /// <summary>Of the viewport.</summary>
        public static readonly Rect All = new Rect(0f, 0f, 1f, 1f);

        private readonly Color[] pixels;

        public Picture(int width, int height, Color[] pixels)
        {
            (Width, Height, this.pixels) = (width, height, pixels);
        }

        public int Width { get; }

        public int Height { get; }

        public Color this[int x, int y] => pixels[y * Width + x];

        public static Picture Of(RenderTexture target)
        {
            RenderTexture before = RenderTexture.active;
            var copy = new Texture2D(target.width, target.height, TextureFormat.RGBA32, false);
            RenderTexture.active = target;
            copy.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            copy.Apply();
            RenderTexture.active = before;
            var picture = new Picture(target.width, target.height, copy.GetPixels());
            Object.DestroyImmediate(copy);
            return picture;
        }

        /// <summary>The pixel that a viewport's point is in.</summary>
        public Color At(Vector2 viewport) =>
            this[Mathf.Clamp((int)(viewport.x * Width), 0, Width - 1), Mathf.Clamp((int)(viewport.y * Height), 0, Height - 1)];

        /// <summary>Mean of the pixels of a part of the viewport, in linear colours.</summary>
        public Color Mean(Rect viewport)
        {
            Color sum = Color.clear;
            int count = 0;
            for (int y = (int)(viewport.yMin * Height); y < (int)(viewport.yMax * Height); y++)
            {
                for (int x = (int)(viewport.xMin * Width); x < (int)(viewport.xMax * Width); x++)
                {
                    sum += this[x, y].linear;
                    count++;
                }
            }
            return sum / count;
        }

        /// <summary>Grey of the brightest pixel of a part of the viewport.</summary>
        public float Brightest(Rect viewport)
        {
            double most = 0.0;
            for (int y = (int)(viewport.yMin * Height); y < (int)(viewport.yMax * Height); y++)
            {
                for (int x = (int)(viewport.xMin * Width); x < (int)(viewport.xMax * Width); x++) most = System.Math.Max(most, Luma(x, y));
            }
            return (float)most;
        }

        /// <summary>Where the red of a part of the viewport lies on average, in parts of the width.</summary>
        public float PlaceOfRed(Rect viewport)
        {
            float weight = 0f, sum = 0f;
            for (int y = (int)(viewport.yMin * Height); y < (int)(viewport.yMax * Height); y++)
            {
                for (int x = (int)(viewport.xMin * Width); x < (int)(viewport.xMax * Width); x++)
                {
                    Color pixel = this[x, y];
                    float red = Mathf.Max(0f, pixel.r - Mathf.Max(pixel.g, pixel.b) - 0.1f);
                    weight += red;
                    sum += red * (x + 0.5f) / Width;
                }
            }
            return sum / weight;
        }

        /// <summary>Half as wide and high: each pixel the mean of four.</summary>
        public Picture Halved()
        {
            var half = new Color[Width / 2 * (Height / 2)];
            for (int i = 0; i < half.Length; i++)
            {
                int x = 2 * (i % (Width / 2)), y = 2 * (i / (Width / 2));
                half[i] = ((this[x, y].linear + this[x + 1, y].linear + this[x, y + 1].linear + this[x + 1, y + 1].linear) / 4f).gamma;
            }
            return new Picture(Width / 2, Height / 2, half);
        }

        /// <summary>Grey from 0 to 1.</summary>
        public double Luma(int x, int y)
        {
            Color pixel = this[x, y];
            return 0.299 * pixel.r + 0.587 * pixel.g + 0.114 * pixel.b;
        }
    }
}
