using System;
using System.Collections.Generic;
using Unity.Collections;

namespace UnityEngine.Rendering.Universal;

/// <summary>
/// Forward+: which lights, and then which reflection probes, may reach a tile of the screen (one bit each), and which a slice of depth (the same
/// bits, with the least and the greatest number before them). Both by bounding spheres.
/// </summary>
internal sealed class LightClusters : IDisposable
{
    private const int BinWords = 1024 * 4;
    private const int TileWords = 4096 * 4;
    private const int HeaderWords = 2;
    private const int SmallestTile = 8;
    private const int MaxProbes = 64;

    private static readonly int Params0 = Shader.PropertyToID("_FPParams0");
    private static readonly int Params1 = Shader.PropertyToID("_FPParams1");
    private static readonly int Params2 = Shader.PropertyToID("_FPParams2");

    private readonly uint[] bins = new uint[BinWords];
    private readonly uint[] tiles = new uint[TileWords];
    private GraphicsBuffer? binBuffer;
    private GraphicsBuffer? tileBuffer;

    public void Set(UnsafeCommandBuffer cmd, UniversalCameraData camera, UniversalLightData lights, CullingResults results)
    {
        (List<Sphere> items, int localLights, int directional) = Items(lights, results);
        int words = (items.Count + 31) / 32;
        int views = camera.ViewCount;
        int width = SmallestTile;
        while (TilesAcross(camera.PixelWidth, width) * TilesAcross(camera.PixelHeight, width) * words * views > TileWords)
        {
            width <<= 1;
        }

        var grid = new Vector2Int(TilesAcross(camera.PixelWidth, width), TilesAcross(camera.PixelHeight, width));
        var slices = new DepthSlices(camera.camera, words, views);
        Array.Clear(bins);
        Array.Clear(tiles);
        for (int view = 0; view < views; view++)
        {
            Fill(camera, view, items, localLights, words, grid, width, slices);
        }


        Upload(cmd);
        cmd.SetGlobalVector(Params0, new Vector4(slices.Scale, slices.Offset, localLights, directional));
        cmd.SetGlobalVector(Params1, new Vector4((float)camera.PixelWidth / width, (float)camera.PixelHeight / width, grid.x, words));
        cmd.SetGlobalVector(Params2, new Vector4(slices.Count, grid.x * grid.y, 0f, 0f));
    }

    public void Dispose()
    {
        binBuffer?.Dispose();
        tileBuffer?.Dispose();
        (binBuffer, tileBuffer) = (null, null);
    }

    private static int TilesAcross(int pixels, int width) => (pixels + width - 1) / width;

    /// <summary>Directional lights come first among the visible ones and are in no cluster.</summary>
    private static (List<Sphere> Items, int Lights, int Directional) Items(UniversalLightData lights, CullingResults results)
    {
        var items = new List<Sphere>();
        int directional = 0;
        foreach (VisibleLight light in lights.visibleLights)
        {
            if (!lights.supportsAdditionalLights)
            {
                break;
            }

            if (light.lightType == LightType.Directional)
            {
                directional++;
            }
            else
            {
                items.Add(new Sphere(light.localToWorldMatrix.GetColumn(3), light.range));
            }
        }

        int count = items.Count;
        foreach (VisibleReflectionProbe probe in results.visibleReflectionProbes)
        {
            if (probe.texture != null && items.Count - count < MaxProbes)
            {
                items.Add(new Sphere(probe.bounds.center, probe.bounds.extents.magnitude));
            }
        }

        return (items, count, Math.Max(0, directional - (directional > 0 && lights.mainLightIndex >= 0 ? 1 : 0)));
    }

    private void Fill(
        UniversalCameraData camera, int view, List<Sphere> items, int lights, int words, Vector2Int grid, int tileWidth, in DepthSlices slices)
    {
        int binStart = view * slices.Count;
        int tileStart = view * grid.x * grid.y;
        for (int bin = 0; bin < slices.Count; bin++)
        {
            // Least above greatest: empty.
            bins[(binStart + bin) * (HeaderWords + words)] = ushort.MaxValue;
            bins[((binStart + bin) * (HeaderWords + words)) + 1] = ushort.MaxValue;
        }

        for (int i = 0; i < items.Count; i++)
        {
            Vector3 at = camera.GetViewMatrix(view).MultiplyPoint3x4(items[i].Center);
            (int first, int last) = slices.Of(-at.z - items[i].Radius, -at.z + items[i].Radius);
            for (int bin = first; bin <= last; bin++)
            {
                Mark((binStart + bin) * (HeaderWords + words), i < lights ? 0 : 1, i);
            }

            RectInt covered = Cover(camera, view, at, items[i].Radius, grid, tileWidth);
            for (int y = covered.yMin; y <= covered.yMax; y++)
            {
                for (int x = covered.xMin; x <= covered.xMax; x++)
                {
                    tiles[((tileStart + (y * grid.x) + x) * words) + (i / 32)] |= 1u << (i % 32);
                }
            }
        }
    }

    private void Mark(int at, int header, int item)
    {
        uint bounds = bins[at + header];
        uint least = Math.Min(bounds & 0xFFFF, (uint)item);
        uint greatest = Math.Max(bounds >> 16, (uint)item);
        bins[at + header] = least | (greatest << 16);
        bins[at + HeaderWords + (item / 32)] |= 1u << (item % 32);
    }

    /// <summary>Tiles that the sphere may show in, both ends included; row 0 is the picture's lowest.</summary>
    private static RectInt Cover(UniversalCameraData camera, int view, Vector3 at, float radius, Vector2Int grid, int tileWidth)
    {
        Matrix4x4 projection = camera.GetProjectionMatrix(view);
        (float left, float right) = (-1f, 1f);
        (float bottom, float top) = (-1f, 1f);
        float near = -at.z - radius;
        if (camera.camera.orthographic)
        {
            (left, right) = Span((at.x * projection.m00) + projection.m03, radius * projection.m00);
            (bottom, top) = Span((at.y * projection.m11) + projection.m13, radius * projection.m11);
        }
        else if (near > camera.camera.nearClipPlane)
        {
            (left, right) = Angles(at.x, -at.z, radius, projection.m00, projection.m02);
            (bottom, top) = Angles(at.y, -at.z, radius, projection.m11, projection.m12);
        }

        int x0 = Tile(left, camera.PixelWidth, tileWidth, grid.x);
        int x1 = Tile(right, camera.PixelWidth, tileWidth, grid.x);
        int y0 = Tile(bottom, camera.PixelHeight, tileWidth, grid.y);
        int y1 = Tile(top, camera.PixelHeight, tileWidth, grid.y);
        return new RectInt(x0, y0, x1 - x0, y1 - y0);
    }

    private static (float Low, float High) Span(float center, float reach) => (center - Math.Abs(reach), center + Math.Abs(reach));

    /// <summary>Where the two tangents from the camera to a circle meet the screen.</summary>
    private static (float Low, float High) Angles(float across, float ahead, float radius, float scale, float offset)
    {
        float distance = Mathf.Sqrt((across * across) + (ahead * ahead));
        float direction = Mathf.Atan2(across, ahead);
        float half = Mathf.Asin(Mathf.Clamp01(radius / distance));
        float low = direction - half > -1.55f ? (Mathf.Tan(direction - half) * scale) - offset : -1f;
        float high = direction + half < 1.55f ? (Mathf.Tan(direction + half) * scale) - offset : 1f;
        return (low, high);
    }

    private static int Tile(float clip, int pixels, int width, int count) => Mathf.Clamp((int)Mathf.Floor(((clip * 0.5f) + 0.5f) * pixels / width), 0, count - 1);

    private void Upload(UnsafeCommandBuffer cmd)
    {
        binBuffer ??= new GraphicsBuffer(GraphicsBuffer.Target.Constant, BinWords / 4, 16) { name = "URP Z-Bin Buffer" };
        tileBuffer ??= new GraphicsBuffer(GraphicsBuffer.Target.Constant, TileWords / 4, 16) { name = "URP Tile Buffer" };
        binBuffer.SetData(bins);
        tileBuffer.SetData(tiles);
        cmd.SetGlobalConstantBuffer(binBuffer, "urp_ZBinBuffer", 0, BinWords * 4);
        cmd.SetGlobalConstantBuffer(tileBuffer, "urp_TileBuffer", 0, TileWords * 4);
    }

    private readonly record struct Sphere(Vector3 Center, float Radius);

    /// <summary>Slices of depth: equal in its logarithm, or in depth itself for an orthographic camera.</summary>
    private readonly struct DepthSlices
    {
        private readonly bool isOrthographic;
        private readonly float near;

        public DepthSlices(Camera camera, int words, int views)
        {
            (isOrthographic, near) = (camera.orthographic, camera.nearClipPlane);
            Scale = BinWords / views / ((Along(camera.farClipPlane) - Along(near)) * (HeaderWords + words));
            Offset = -Along(near) * Scale;
            Count = Math.Max(0, (int)((Along(camera.farClipPlane) * Scale) + Offset));
        }

        public float Scale { get; }
        public float Offset { get; }
        public int Count { get; }

        public (int First, int Last) Of(float from, float to)
        {
            if (to < near)
            {
                return (0, -1);
            }

            int first = (int)((Along(Math.Max(near, from)) * Scale) + Offset);
            int last = (int)((Along(Math.Max(near, to)) * Scale) + Offset);
            return (Math.Max(0, first), Math.Min(Count - 1, last));
        }

        private float Along(float depth) => isOrthographic ? depth : Mathf.Log(depth, 2f);
    }
}
