using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Ties terrain data to an object. It is not drawn.</summary>
public sealed class Terrain : Behaviour
{
    static readonly List<Terrain> s_Active = new();

    public TerrainData terrainData { get; set; } = null!;
    public static Terrain[] activeTerrains => s_Active.ToArray();

    internal static List<Terrain> Using(TerrainData data) => s_Active.FindAll(t => ReferenceEquals(t.terrainData, data));

    internal override void OnAdded() => s_Active.Add(this);
    internal override void OnRemoved() => s_Active.Remove(this);
}
