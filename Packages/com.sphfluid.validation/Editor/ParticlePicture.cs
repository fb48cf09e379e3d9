using System;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>Particles as shaded discs, orthographic, one panel beside another; drawn on the CPU, so the same everywhere.</summary>
    internal sealed class ParticlePicture
    {
        private const int Gap = 12;

        private static readonly Color32 Paper = new Color32(245, 246, 248, 255);
        private static readonly Color32 Frame = new Color32(120, 126, 136, 255);

        private readonly Color32[] pixels;
        private readonly int panels, panelWidth, panelHeight;

        /// <summary>An empty picture.</summary>
        /// <param name="panels">Number of panels.</param>
        /// <param name="panelWidth">Width of a panel [pixels].</param>
        /// <param name="panelHeight">Height of a panel [pixels].</param>
        public ParticlePicture(int panels, int panelWidth, int panelHeight)
        {
            this.panels = panels;
            this.panelWidth = panelWidth;
            this.panelHeight = panelHeight;
            pixels = new Color32[Width * Height];
            for (int i = 0; i < pixels.Length; i++) pixels[i] = Paper;
        }

        private int Width => panels * panelWidth + (panels + 1) * Gap;

        private int Height => panelHeight + 2 * Gap;

        /// <summary>Draws particles that fill a panel with their box.</summary>
        /// <param name="panel">Number of the panel, from the left.</param>
        /// <param name="particles">The particles, sorted here by distance.</param>
        /// <param name="value">A number for each, 0 blue to 1 red.</param>
        /// <param name="box">Size of the domain [m].</param>
        /// <param name="fromAbove">Look down instead of along z.</param>
        /// <param name="radius">Radius of a particle [m].</param>
        public void Draw(int panel, FluidParticle[] particles, float[] value, Vector3 box, bool fromAbove, float radius)
        {
            float scale = panelWidth / box.x;
            int left = Gap + panel * (panelWidth + Gap);
            var order = new int[particles.Length];
            var depth = new float[particles.Length];
            for (int i = 0; i < order.Length; i++)
            {
                order[i] = i;
                depth[i] = fromAbove ? particles[i].Position.y : -particles[i].Position.z;
            }
            Array.Sort(depth, order);
            DrawFrame(left);
            foreach (int i in order)
            {
                Vector3 p = particles[i].Position;
                float up = fromAbove ? p.z + 0.5f * box.z : p.y + 0.5f * box.y;
                Disc(left + scale * (p.x + 0.5f * box.x), Gap + scale * up, scale * radius, Ramp(value[i]));
            }
        }

        /// <summary>The picture as a file.</summary>
        /// <returns>PNG.</returns>
        public byte[] ToPng()
        {
            var texture = new Texture2D(Width, Height, TextureFormat.RGB24, false);
            texture.SetPixels32(pixels);
            byte[] file = texture.EncodeToPNG();
            UnityEngine.Object.DestroyImmediate(texture);
            return file;
        }

        private void DrawFrame(int left)
        {
            for (int x = -1; x <= panelWidth; x++)
            {
                Set(left + x, Gap - 1, Frame);
                Set(left + x, Gap + panelHeight, Frame);
            }
            for (int y = -1; y <= panelHeight; y++)
            {
                Set(left - 1, Gap + y, Frame);
                Set(left + panelWidth, Gap + y, Frame);
            }
        }

        // Darker towards the rim, so that discs that overlap stay apart.
        private void Disc(float cx, float cy, float radius, Color colour)
        {
            for (int y = Mathf.FloorToInt(cy - radius); y <= Mathf.CeilToInt(cy + radius); y++)
            {
                for (int x = Mathf.FloorToInt(cx - radius); x <= Mathf.CeilToInt(cx + radius); x++)
                {
                    float dx = x + 0.5f - cx, dy = y + 0.5f - cy;
                    float part = (dx * dx + dy * dy) / (radius * radius);
                    if (part <= 1f) Set(x, y, colour * (1f - 0.6f * part * part));
                }
            }
        }

        private void Set(int x, int y, Color colour)
        {
            colour.a = 1f;
            if (x >= 0 && y >= 0 && x < Width && y < Height) pixels[y * Width + x] = colour;
        }

        private static Color Ramp(float value)
        {
            float t = Mathf.Clamp01(value);
            var low = new Color(0.16f, 0.42f, 0.80f);
            var middle = new Color(0.95f, 0.80f, 0.35f);
            var high = new Color(0.80f, 0.16f, 0.14f);
            return t < 0.5f ? Color.Lerp(low, middle, 2f * t) : Color.Lerp(middle, high, 2f * t - 1f);
        }
    }
}
