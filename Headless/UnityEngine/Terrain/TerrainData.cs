using System;
using Headless.Engine;

namespace UnityEngine;

/// <summary>Heights and holes of a terrain. Heights are kept as floats; Unity rounds them to 16 bits.</summary>
public sealed class TerrainData : Object
{
    const int MinResolution = 33, MaxResolution = 4097;

    int m_Resolution = MinResolution;
    Vector3 m_Scale = new(1f, 600f, 1f); // of a cell; y of a height of 1
    float[,] m_Heights = new float[MinResolution, MinResolution];
    bool[,] m_Holes = Surface(MinResolution - 1);

    public static string HolesTextureName => "holes";

    /// <summary>Rounded up to a power of two plus one, 33 to 4,097. A new one clears heights and holes and keeps the size of a cell.</summary>
    public int heightmapResolution
    {
        get => m_Resolution;
        set
        {
            m_Resolution = Math.Clamp(Mathf.NextPowerOfTwo(Math.Clamp(value, 2, MaxResolution) - 1) + 1, MinResolution, MaxResolution);
            m_Heights = new float[m_Resolution, m_Resolution];
            m_Holes = Surface(m_Resolution - 1);
        }
    }

    public int holesResolution => m_Resolution - 1;

    public Vector3 size
    {
        get => new(m_Scale.x * (m_Resolution - 1), m_Scale.y, m_Scale.z * (m_Resolution - 1));
        set => m_Scale = new Vector3(value.x / (m_Resolution - 1), value.y, value.z / (m_Resolution - 1));
    }

    /// <summary>Heights from 0 to 1 by row (z) and column (x).</summary>
    public float[,] GetHeights(int xBase, int yBase, int width, int height) => Part(m_Heights, xBase, yBase, width, height);

    /// <summary>By row and column of a cell: false is a hole.</summary>
    public bool[,] GetHoles(int xBase, int yBase, int width, int height) => Part(m_Holes, xBase, yBase, width, height);

    public void SetHeights(int xBase, int yBase, float[,] heights)
    {
        Copy(heights, m_Heights, xBase, yBase, h => Mathf.Clamp01(h));
        foreach (Terrain terrain in Terrain.Using(this))
            TerrainCallbacks.RaiseHeightmap(terrain, new RectInt(xBase, yBase, heights.GetLength(1), heights.GetLength(0)));
    }

    public void SetHoles(int xBase, int yBase, bool[,] holes)
    {
        Copy(holes, m_Holes, xBase, yBase, h => h);
        foreach (Terrain terrain in Terrain.Using(this))
            TerrainCallbacks.RaiseTexture(terrain, HolesTextureName, new RectInt(xBase, yBase, holes.GetLength(1), holes.GetLength(0)));
    }

    static bool[,] Surface(int cells)
    {
        var surface = new bool[cells, cells];
        for (int z = 0; z < cells; z++)
            for (int x = 0; x < cells; x++) surface[z, x] = true;
        return surface;
    }

    static T[,] Part<T>(T[,] all, int xBase, int yBase, int width, int height)
    {
        Check(all, xBase, yBase, width, height);
        var part = new T[height, width];
        for (int z = 0; z < height; z++)
            for (int x = 0; x < width; x++) part[z, x] = all[yBase + z, xBase + x];
        return part;
    }

    static void Copy<T>(T[,] part, T[,] all, int xBase, int yBase, Func<T, T> limit)
    {
        if (part == null) throw new ArgumentNullException(nameof(part));
        Check(all, xBase, yBase, part.GetLength(1), part.GetLength(0));
        for (int z = 0; z < part.GetLength(0); z++)
            for (int x = 0; x < part.GetLength(1); x++) all[yBase + z, xBase + x] = limit(part[z, x]);
    }

    static void Check<T>(T[,] all, int xBase, int yBase, int width, int height)
    {
        if (xBase < 0 || yBase < 0 || width < 0 || height < 0 || xBase + width > all.GetLength(1) || yBase + height > all.GetLength(0))
            throw new ArgumentException("Trying to access out-of-bounds terrain data.");
    }
}
