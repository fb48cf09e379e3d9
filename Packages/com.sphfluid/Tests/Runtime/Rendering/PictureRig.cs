using System;
using System.Collections;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A camera that looks along z at the origin, a light over its shoulder, and what they saw in the last frame.</summary>
    internal sealed class PictureRig : IDisposable
    {
        private readonly GameObject holder;
        private readonly GameObject lamp;
        private readonly RenderTexture target;

        public PictureRig(int width, int height, float orthographicSize)
        {
            Width = width;
            Height = height;
            target = new RenderTexture(width, height, 24);
            holder = new GameObject("Camera");
            holder.transform.position = new Vector3(0f, 0f, -2f);
            Camera = holder.AddComponent<Camera>();
            Camera.orthographic = true;
            Camera.orthographicSize = orthographicSize;
            Camera.clearFlags = CameraClearFlags.SolidColor;
            Camera.backgroundColor = Color.black;
            Camera.targetTexture = target;
            lamp = new GameObject("Light");
            Light = lamp.AddComponent<Light>();
            Light.type = LightType.Directional;
            Light.transform.rotation = Quaternion.Euler(30f, 20f, 0f);
        }

        public int Width { get; }

        public int Height { get; }

        public Camera Camera { get; }

        public Light Light { get; }

        /// <summary>
        /// Pixels of the last frame, row 0 the lowest. A liquid is drawn for one frame at a time: Camera.Render between frames would not
        /// see it.
        /// </summary>
        public Color[] Pixels()
        {
            RenderTexture before = RenderTexture.active;
            var picture = new Texture2D(Width, Height, TextureFormat.RGBA32, false);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, Width, Height), 0, 0);
            picture.Apply();
            RenderTexture.active = before;
            Color[] pixels = picture.GetPixels();
            Object.DestroyImmediate(picture);
            return pixels;
        }

        /// <summary>The pixel that shows a point of world space.</summary>
        public Color PixelAt(Color[] pixels, Vector3 point)
        {
            Vector3 seen = Camera.WorldToViewportPoint(point);
            return pixels[Mathf.FloorToInt(seen.y * Height) * Width + Mathf.FloorToInt(seen.x * Width)];
        }

        /// <summary>Waits for frames: <c>yield return</c> it.</summary>
        public static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++) yield return null;
        }

        public void Dispose()
        {
            Camera.targetTexture = null;
            Object.DestroyImmediate(holder);
            Object.DestroyImmediate(lamp);
            target.Release();
            Object.DestroyImmediate(target);
        }
    }
}
