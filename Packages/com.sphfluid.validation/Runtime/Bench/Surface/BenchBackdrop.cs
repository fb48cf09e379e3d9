using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What is behind the water of the benchmark: a tiled floor below the liquid, as picture and as depth.</summary>
    internal sealed class BenchBackdrop : IDisposable
    {
        private const float Tile = 0.125f;

        private Texture2D depth;
        private RenderTexture colour;

        /// <param name="view">World to camera.</param>
        /// <param name="projection">Its projection: perspective.</param>
        /// <param name="near">Near plane [m].</param>
        /// <param name="far">Far plane [m].</param>
        /// <param name="floor">Height of the floor [m].</param>
        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        public BenchBackdrop(Matrix4x4 view, Matrix4x4 projection, float near, float far, float floor, int width, int height)
        {
            Matrix4x4 toWorld = view.inverse;
            Vector3 eye = toWorld.MultiplyPoint3x4(Vector3.zero);
            var metres = new float[width * height];
            var tiles = new Color[width * height];
            for (int i = 0; i < metres.Length; i++)
            {
                var onPlane = new Vector3((2f * (i % width + 0.5f) / width - 1f) / projection.m00,
                    (2f * (i / width + 0.5f) / height - 1f) / projection.m11, -1f);
                Vector3 ray = toWorld.MultiplyVector(onPlane);
                float away = ray.y < 0f ? Mathf.Min((floor - eye.y) / ray.y, far) : far;
                Vector3 seen = eye + away * ray;
                bool isDark = (Mathf.FloorToInt(seen.x / Tile) + Mathf.FloorToInt(seen.z / Tile)) % 2 == 0;
                metres[i] = RawDepth(away, near, far);
                tiles[i] = away < far ? isDark ? new Color(0.5f, 0.5f, 0.5f) : Color.white : new Color(0.6f, 0.7f, 0.8f);
            }
            depth = new Texture2D(width, height, TextureFormat.RFloat, false, true) { hideFlags = HideFlags.HideAndDontSave };
            depth.SetPixelData(metres, 0);
            depth.Apply();
            var picture = new Texture2D(width, height, TextureFormat.RGBA32, false);
            picture.SetPixels(tiles);
            picture.Apply();
            colour = new RenderTexture(width, height, 0, RenderTextureFormat.DefaultHDR)
            {
                name = "Benchmark Backdrop",
                hideFlags = HideFlags.HideAndDontSave
            };
            Graphics.Blit(picture, colour);
            UnityEngine.Object.DestroyImmediate(picture);
        }

        /// <summary>The picture.</summary>
        public RenderTexture Colour => colour;

        /// <summary>The depth, as a camera's depth texture has it.</summary>
        public Texture Depth => depth;

        /// <summary>What turns such depths into metres: Unity's _ZBufferParams.</summary>
        public static Vector4 BufferParameters(float near, float far) => SystemInfo.usesReversedZBuffer
            ? new Vector4(far / near - 1f, 1f, (far / near - 1f) / far, 1f / far)
            : new Vector4(1f - far / near, far / near, (1f - far / near) / far, 1f / near);

        public void Dispose()
        {
            if (colour == null) return;
            colour.Release();
            UnityEngine.Object.DestroyImmediate(colour);
            UnityEngine.Object.DestroyImmediate(depth);
            colour = null;
            depth = null;
        }

        private static float RawDepth(float metres, float near, float far)
        {
            Vector4 parameters = BufferParameters(near, far);
            return (1f / metres - parameters.w) / parameters.z;
        }
    }
}
